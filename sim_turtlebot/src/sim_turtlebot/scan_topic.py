"""The topic of one robot's laser scan."""

from odometry_common.kobuki import DEPTH_CAMERA_FRAME
from odometry_common.publishing import advertise
from sensor_msgs.msg import LaserScan

from sim_turtlebot.numbering import numbered, publish
from sim_turtlebot.scanner import is_scan_due

NumberedLaserScan = numbered(LaserScan)


class ScanTopic:
    """Publishes what a Scanner measures, when there is somebody to whom it matters."""

    def __init__(self, scanner, namespace, rate, odom_rate):
        """Advertise.

        :param scanner: sim_turtlebot.scanner.Scanner
        :param namespace: '' or one that ends in a slash; topic and frame begin with it
        :param rate, odom_rate: Hz, of scans and of odometry
        """
        self._scanner = scanner
        self._rates = rate, odom_rate
        self._message = NumberedLaserScan(
            angle_min=-scanner.field_of_view / 2, angle_max=scanner.field_of_view / 2,
            angle_increment=scanner.field_of_view / (scanner.beams - 1), scan_time=1 / rate,
            range_min=scanner.range_min, range_max=scanner.range_max)
        self._message.header.frame_id = f'{namespace}{DEPTH_CAMERA_FRAME}'
        self.publisher = advertise(f'{namespace}scan', LaserScan)

    def publish(self, stamp, number):
        """Publish a scan if one is due, with the odometry of the same moment.

        :param stamp: rospy.Time
        :param number: how many odometry periods have passed
        """
        # Rays cost more than all else that happens between two odometries.
        if self.publisher.get_num_connections() and is_scan_due(number, *self._rates):
            self._message.ranges = self._scanner.scan(number).tolist()
            publish(self.publisher, self._message, stamp, number)

#!/usr/bin/env python3
import rospy, math
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

class MovementDetector(object):
    def __init__(self):
        self._moved = Float64()
        self._moved.data = 0.0
        self.get_init_position()
        self.pub = rospy.Publisher('/moved_distance', Float64, queue_size=1)
        rospy.Subscriber('/odom', Odometry, self.callback)

    def get_init_position(self):
        data_odom = None
        while data_odom is None and not rospy.is_shutdown():
            try:
                data_odom = rospy.wait_for_message('/odom', Odometri, timeout=1)
            except:
                rospy.loginfo('Current odom not ready yet, retrying')
                rospy.rostime.wallsleep(0.1)
        self.position = data_odom.pose.pose.position

    def callback(self, msg):
        p = msg.pose.pose.position
        self._moved.data += math.hypot(p.x - self.position.x, p.y - self.position.y)
        self.position = p
        self.pub.publish(self._moved)

rospy.init_node('movement_detector_node', anonymous=True)
MovementDetector()
rospy.spin()

"""Three nodes of bare rospy that pass the messages of a move on: the limit of lockstep.

usage: ring.py robot | detector | mover

The robot is PyBullet stepping from one odometry to the next, and nothing else. It publishes what
the simulator does; the others receive what the detector and the mover receive.

Subscribes:
    ring/run (std_msgs/Float64): go round for so many seconds of wall time

Publishes:
    ring/ran (std_msgs/Float64): simulated seconds per second
"""

import queue
import sys

import rospy
from geometry_msgs.msg import TransformStamped, Twist
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage
from worlds import BareWorld, speed_of

TIMEOUT = 30.0  # s, for an answer


def robot():
    world, heard = BareWorld(), queue.Queue()
    clock, tf = advertise('ring/clock', Clock), advertise('ring/tf', TFMessage)
    odometry = advertise('ring/odom', Odometry)
    ground_truth = advertise('ring/base_pose_ground_truth', Odometry)
    ran = advertise('ring/ran', Float64)
    rospy.Subscriber('ring/cmd_vel', Twist, heard.put, tcp_nodelay=True)

    def go_round():
        world.run_to_odometry()
        clock.publish(Clock())
        odometry.publish(Odometry())
        ground_truth.publish(Odometry())
        tf.publish(TFMessage([TransformStamped()]))
        heard.get(timeout=TIMEOUT)

    windows = queue.Queue()
    rospy.Subscriber('ring/run', Float64, windows.put)
    rospy.on_shutdown(lambda: windows.put(None))
    while (message := windows.get()) is not None:
        ran.publish(speed_of(go_round, message.data))


def relay(question, question_class, answer, answer_class):
    publisher = advertise(answer, answer_class)
    rospy.Subscriber('ring/clock', Clock, lambda _: None, tcp_nodelay=True)
    rospy.Subscriber(question, question_class, lambda _: publisher.publish(answer_class()),
                     tcp_nodelay=True)
    rospy.spin()


def detector():
    relay('ring/odom', Odometry, 'ring/moved_distance', Float64)


def mover():
    relay('ring/moved_distance', Float64, 'ring/cmd_vel', Twist)


if __name__ == '__main__':
    # disable_rostime: the clock here is another simulator's.
    rospy.init_node('ring', anonymous=True, disable_rostime=True)
    {'robot': robot, 'detector': detector, 'mover': mover}[sys.argv[1]]()

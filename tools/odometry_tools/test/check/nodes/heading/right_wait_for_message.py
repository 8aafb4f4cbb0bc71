#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry


def yaw_of(q):
    return math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y ** 2 + q.z ** 2))


if __name__ == '__main__':
    rospy.init_node('rotate', anonymous=True)
    pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
    rospy.on_shutdown(lambda: pub.publish(Twist()))
    try:
        while True:
            q = rospy.wait_for_message('/odom', Odometry, timeout=5).pose.pose.orientation
            e = math.radians(90) - yaw_of(q)
            e = math.atan2(math.sin(e), math.cos(e))
            t = Twist()
            if abs(e) < math.radians(1):
                break
            t.angular.z = 0.6 * e
            pub.publish(t)
    except rospy.ROSException:
        pass
    else:
        pub.publish(Twist())
        rospy.rostime.wallsleep(0.3)

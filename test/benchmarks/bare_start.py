"""Import rospy and PyBullet and become a node: nothing starts sooner than this."""

import pybullet
import rospy

rospy.init_node('bare_start', anonymous=True)
print('ready with PyBullet', pybullet.getAPIVersion(), flush=True)
rospy.spin()

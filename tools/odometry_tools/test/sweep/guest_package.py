"""The files of a user's package whose launch files are swept."""

NODE = '''#!{python}
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
rospy.init_node('node')
odometry = Odometry()
rospy.Subscriber('odom', Odometry, lambda message: globals().update(odometry=message))
publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rate = rospy.Rate(10)
command = Twist()
command.linear.x = 0.5
end = rospy.get_param('~end')
for number in range(10):
    publisher.publish(command)
    rate.sleep()
    if end == 'crash' and number == 5 or end == 'chance' and int(1e4 * odometry.pose.pose.position.x) % 4 == 3:
        raise ValueError('on \\x1b[31mpurpose')
    while end == 'busy' and not rospy.is_shutdown():
        pass
if end == 'never':
    rospy.spin()
'''
NODES = '''<launch>
  <arg name="end" default="done"/>
  <node name="node" pkg="guest" type="node.py" required="true"><param name="end" value="$(arg end)"/></node>
</launch>'''
HELPER = '''<launch>
  <arg name="x" default="done"/>
  <node name="node" pkg="guest" type="node.py"><param name="end" value="$(arg x)"/></node>
  <node name="helper" pkg="guest" type="helper.sh"/>
</launch>'''
ONE_NODE = '<launch><node name="{0}" pkg="guest" type="{0}.py">{1}</node></launch>'
NAPPER = '''#!{python}
import select, threading, time
import rospy
from geometry_msgs.msg import Twist
rospy.init_node('napper')
publisher, number = rospy.Publisher('cmd_vel', Twist, queue_size=1), 0
nap = dict(sleep=time.sleep, select=lambda seconds: select.select([], [], [], seconds),
           event=threading.Event().wait)[rospy.get_param('~nap')]
while not rospy.is_shutdown():
    number += 1
    command = Twist()
    command.linear.x = 0.1 + 0.02 * (number % 5)
    publisher.publish(command)
    nap(0.1)
'''
NAPS = '''<launch>
  <arg name="nap"/>
  <node name="node" pkg="guest" type="napper.py"><param name="nap" value="$(arg nap)"/></node>
</launch>'''
# Fails if another run has left its parameter.
TIDY = '''#!{python}
import rospy
rospy.init_node('tidy')
assert not rospy.has_param('/left'), 'left'
rospy.set_param('/left', True)
'''
# Commands once, before time begins: the simulator ignores that.
EARLY = '''#!{python}
import time
import rospy
from geometry_msgs.msg import Twist
rospy.init_node('early')
publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
while publisher.get_num_connections() < 2:
    time.sleep(0.01)
publisher.publish(Twist())
rospy.spin()
'''
# Lets the node `late` start once simulated time has begun, and computes until it is there.
BRAKE = '''#!{python}
import os
import time
import rosgraph
import rospy
from nav_msgs.msg import Odometry

def await_late(_message):
    if not os.path.exists(begun):
        return
    open(begun, 'w').close()
    os.remove(begun)
    while '/late' not in str(rosgraph.Master('/brake').getSystemState()):
        end = time.process_time() + 0.05
        while time.process_time() < end:
            pass

begun = os.path.join(os.environ['ROS_LOG_DIR'], 'begun')
rospy.init_node('brake')
rospy.Subscriber('odom', Odometry, await_late)
rospy.spin()
'''
LATE = '''<launch>
  <node name="brake" pkg="guest" type="brake.py"/>
  <node name="late" pkg="guest" type="late.sh"><param name="end" value="never"/></node>
</launch>'''
# Calls a service of the robot, and goes on.
CALLER = '''#!{python}
import rospy
from std_srvs.srv import Empty
rospy.init_node('caller')
rospy.sleep(1.0)
rospy.ServiceProxy(rospy.get_param('~service'), Empty)()
rospy.spin()
'''
CALLS = '''<launch>
  <arg name="service"/>
  <node name="node" pkg="guest" type="caller.py">
    <param name="service" value="sim_turtlebot/$(arg service)"/>
  </node>
</launch>'''
# Of another type, which may not be there.
TYPED = '''<launch>
  <arg name="type"/>
  <arg name="time" default="1"/>
  <node name="node" pkg="guest" type="$(arg type)"/>
</launch>'''
AGAIN = '<launch><node name="again" pkg="guest" type="again.sh" respawn="true"/></launch>'
REMOTE = '''<launch>
  <machine name="other" address="192.0.2.7" env-loader="/env.sh"/>
  <node name="node" pkg="guest" type="node.py" machine="other"/>
</launch>'''
FILES = {
    'package.xml': '<package><name>guest</name></package>', 'node.py': NODE, 'nodes.launch': NODES,
    'napper.py': NAPPER, 'naps.launch': NAPS, 'tidy.py': TIDY, 'tidy.launch': ONE_NODE.format('tidy', ''),
    'helper.sh': '#!/bin/sh\nexec sleep 3000\n', 'helper.launch': HELPER,
    'caller.py': CALLER, 'calls.launch': CALLS, 'typed.launch': TYPED, 'remote.launch': REMOTE,
    'late.sh': '#!/bin/sh\nmkfifo "$ROS_LOG_DIR/begun"\ncat "$ROS_LOG_DIR/begun"\nexec "${0%/*}/node.py" "$@"\n',
    'late.launch': LATE, 'brake.py': BRAKE,
    'again.sh': '#!/bin/sh\necho again >&2\n', 'again.launch': AGAIN,
    'eval.launch': '<launch><param name="x" value="$(eval 1 / 0)"/></launch>',
    'robot.launch': '<launch><node name="sim_turtlebot" pkg="guest" type="node.py"/></launch>',
    'early.py': EARLY, 'early.launch': ONE_NODE.format('early', ''), 'plain.launch': ONE_NODE.format('plain', ''),
    'elsewhere.launch': ONE_NODE.format('node', '<env name="ROS_MASTER_URI" value="http://localhost:1"/>'),
    'none.launch': '<launch/>'}
# Follows a launch file; with a second argument, until a node has ended.
FOLLOW = '''
import sys
import threading
from odometry_tools.runs.launch import Launch
from odometry_tools.runs.output import run_command

def follow():
    with Launch('guest', sys.argv[1], {}, is_watched=bool(sys.argv[2:])) as launch:
        launch.wait_for(threading.Event().is_set, 'nothing happens')

run_command(follow, ())
'''

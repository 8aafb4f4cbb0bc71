"""What the nodes print into a pipe: `rosrun ... | tee` and `rosrun ... | head`."""

import rospy
from geometry_msgs.msg import Twist
from odometry_launch.process_guard import GuardedProcess
from odometry_tests.processes import Process
from odometry_tests.tutorial import detector
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64


def test_a_line_is_seen_while_the_node_runs(master):
    """Python keeps what is printed into a pipe until the node ends, unless told otherwise."""
    with detector(start=GuardedProcess) as node:
        node.wait_for_output('waiting for odometry on /odom')
        assert node.running


def test_a_log_line_that_nobody_reads_any_more_ends_the_node_quietly(master):
    """As a line of output does: the robot is told to stop, and there is no traceback."""
    commands = Recorder('cmd_vel', Twist)
    distances = rospy.Publisher('moved_distance', Float64, queue_size=100)
    pipeline = 'rosrun test_movement test_movement.py | true; echo "status ${PIPESTATUS[0]}"'
    with Process('bash', '-c', pipeline) as shell:
        # At the goal the mover commands zero and says nothing: everybody is connected then.
        wait_until(lambda: distances.publish(3.0) or commands.last, 20.0, 'a command')
        distances.publish(0.0)
        assert shell.wait() == 0, shell.output
    assert shell.output.split('\n') == ['status 0', '']
    wait_until(lambda: [m.linear.x for m in commands.messages][-2:] == [0.1, 0.0], 20.0,
               lambda: f'zero after 0.1 m/s; the last commands are\n{commands.messages[-2:]}')

"""What a report quotes of a node's output."""

import pytest
from odometry_tools.runs.plain_text import plain
from odometry_tools.runs.quoting import error_in

TRACEBACK = '''Error: 1.57
Traceback (most recent call last):
  File "/home/me/turn.py", line 26, in cb
    yaw = m.pose.orientatoin
          ^^^^^^^^^^^^^^^^^^
  File "/opt/ros/lib/rospy.py", line 7, in call
    go()
AttributeError: 'Pose' object has no attribute 'orientatoin'
Error: 0.5
'''
SYNTAX = '''  File "/home/me/turn.py", line 5
    print m
    ^^^^^^^
SyntaxError: Missing parentheses
'''


@pytest.mark.parametrize('output, error', [
    (TRACEBACK, "AttributeError: 'Pose' object has no attribute 'orientatoin', line 26"),
    (SYNTAX.replace('SyntaxError', 'rospy.ROSInterruptException'), ''),
    (SYNTAX, 'SyntaxError: Missing parentheses, line 5'),
    ('Traceback (most recent call last):\nError: 1.57\n', '')])
def test_an_error_is_one_of_a_traceback(output, error):
    assert error_in(output) == error


@pytest.mark.parametrize('printed, quoted', [
    ('\x1b[31mred\x1b[0m', 'red'), ('a\x00b\x07', 'ab'), ('\x1b]0;title\x07text', 'text'),
    ('[ERROR] [1700000000.123456, 1.250000]: no imu', 'no imu'), ('[ INFO] [1700000000.1]: up', 'up'),
    ('<T object at 0x7f7e26f47f10>', '<T object at 0x...>'), ('http://localhost:11312/', 'http://localhost:.../'),
    ('process has died [pid 123, exit code 1', 'process has died [pid ..., exit code 1'), ('\udcff', '')])
def test_what_differs_each_time_or_steers_a_terminal_is_left_out(printed, quoted):
    assert plain(printed) == quoted

"""Robot clients that compute, here or in other processes, that command too early, or that lockstep cannot wait for.

usage: odd_clients.py KIND
"""

import multiprocessing
import os
import queue
import select
import signal
import subprocess
import sys
import threading
import time

import rospy
from clients import main, rate
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rospy.impl import tcpros_pubsub
from rospy.impl.registration import RegManager
from std_srvs.srv import Empty


def long(robot):
    """Compute for three seconds, as SLAM does, before each of the first two commands."""
    for number, x in enumerate(iter(robot.seen.get, None)):
        end = time.process_time() + (3.0 if number < 2 else 0.0)
        while time.process_time() < end:
            pass
        robot.drive(x)


def program(robot):
    for x in iter(robot.seen.get, None):
        code = f'print({x} + 0 * sum(range(200_000)))'
        done = subprocess.run([sys.executable, '-c', code], stdout=subprocess.PIPE, check=True)
        robot.drive(float(done.stdout))


def work(x):
    sum(range(200_000))
    return x


def processes(robot):
    pool = multiprocessing.Pool(2)
    for x in iter(robot.seen.get, None):
        robot.drive(pool.apply(work, [x]))


def busy(_robot):
    while not rospy.is_shutdown():
        pass


def busy_thread(robot):
    threading.Thread(target=busy, args=[robot], daemon=True).start()
    rate(robot)


def flood(robot):
    publisher = rospy.Publisher('cmd_vel', Twist, queue_size=None)
    robot.seen.get()
    while not rospy.is_shutdown():
        publisher.publish(Twist())


def flood_service(_robot):
    rospy.wait_for_service('sim_turtlebot/unpause_physics')
    ask = rospy.ServiceProxy('sim_turtlebot/unpause_physics', Empty)
    while not rospy.is_shutdown():
        ask()


def wall(robot, seconds):
    while not rospy.is_shutdown():
        robot.drive()
        rospy.loginfo('commanded')
        time.sleep(float(seconds))


def selecting(robot):
    while not rospy.is_shutdown():
        select.select([], [], [], 0.1)
        robot.drive()


def wall_timer(robot):
    robot.drive()
    threading.Timer(0.1, wall_timer, [robot]).start()


def early(robot):
    while not robot.is_heard:
        time.sleep(0.01)
    robot.drive(0.0)
    rospy.spin()


def held_up(_robot):
    """Print how far (s) time goes on while a connection is held up for a second, after the master's answer was lost."""
    rospy.wait_for_service('sim_turtlebot/step')  # the simulator offers it last
    update, RegManager.publisher_update = RegManager.publisher_update, lambda *_: None
    connect, messages = tcpros_pubsub.robust_connect_subscriber, queue.Queue()
    tcpros_pubsub.robust_connect_subscriber = lambda *arguments: time.sleep(1.0) or connect(*arguments)
    begin = rospy.get_time()
    rospy.Subscriber('base_pose_ground_truth', Odometry, messages.put)
    RegManager.publisher_update = update
    print('subscribed', flush=True)
    print('went on for', messages.get().header.stamp.to_sec() - begin, flush=True)


def nameless(robot):
    """Command without the own name in the connection's header, which rospy accepts."""
    fields = tcpros_pubsub.TCPROSPub.get_header_fields
    tcpros_pubsub.TCPROSPub.get_header_fields = lambda self: {
        name: value for name, value in fields(self).items() if name != 'callerid'}
    rate(robot)


def stopped(robot):
    """Stop as in a debugger, some time later."""
    for _ in range(20):
        robot.seen.get()
    os.kill(os.getpid(), signal.SIGSTOP)


if __name__ == '__main__':
    main(globals())

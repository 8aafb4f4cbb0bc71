"""Robot clients that lockstep cannot wait for, that command too early, or that start many threads.

usage: odd_clients.py KIND
"""

import asyncio
import os
import queue
import select
import signal
import threading
import time

import rospy
from clients import main, rate
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rospy.impl import tcpros_pubsub
from std_srvs.srv import Empty


def busy(_robot):
    while not rospy.is_shutdown():
        pass


def busy_after_one_command(robot):
    robot.drive(robot.seen.get())
    while robot.x < 1.0:
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


def event(robot):
    while not rospy.is_shutdown():
        threading.Event().wait(0.1)
        robot.drive()


def queue_timeout(robot):
    while not rospy.is_shutdown():
        try:
            queue.Queue().get(timeout=0.1)
        except queue.Empty:
            robot.drive()


def selecting(robot):
    while not rospy.is_shutdown():
        select.select([], [], [], 0.1)
        robot.drive()


def coroutine(robot):
    async def drive():
        while not rospy.is_shutdown():
            robot.drive()
            await asyncio.sleep(0.1)

    asyncio.run(drive())


def wall_timer(robot):
    robot.drive()
    threading.Timer(0.1, wall_timer, [robot]).start()


def alarm(robot):
    signal.signal(signal.SIGALRM, lambda *_: robot.drive())
    signal.setitimer(signal.ITIMER_REAL, 0.1, 0.1)
    while not rospy.is_shutdown():
        signal.pause()


def early(robot):
    while not robot.is_heard:
        time.sleep(0.01)
    robot.drive(0.0)
    rospy.spin()


def held_up(_robot):
    """Print how far (s) time goes on while a connection to the simulator is held up for a second."""
    connect, messages = tcpros_pubsub.robust_connect_subscriber, queue.Queue()
    tcpros_pubsub.robust_connect_subscriber = lambda *arguments: time.sleep(1.0) or connect(*arguments)
    begin = rospy.get_time()
    rospy.Subscriber('base_pose_ground_truth', Odometry, messages.put)
    print('subscribed', flush=True)
    print('went on for', messages.get().header.stamp.to_sec() - begin, flush=True)


def short_threads(robot):
    """Start threads that end at once, as rospy.Timer(oneshot=True) and threading.Timer do."""
    for _ in iter(robot.seen.get, None):
        for _ in range(20):
            threading.Thread(target=int).start()


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

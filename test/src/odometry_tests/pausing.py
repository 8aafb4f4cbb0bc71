"""The simulator's services, and a pause that is certain."""

import rospy
from std_srvs.srv import Empty

from odometry_tests.tutorial import is_at_rest
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until

TURNS = 200  # of the simulator's loop; were it not paused, it would simulate between them
WATCHED = 2.0  # s of the robot's time


def call(service, namespace='/'):
    """Call a service of the simulator in a namespace that ends in a slash."""
    _service(service, namespace)()


def pause(*recorders, namespace='/'):
    """Pause the robot; return once the recorders have all messages sent before.

    A starved simulator is silent too, so wall time proves nothing: the recorders must not change
    while the simulator's loop turns many times. By then it has also read its own input.
    """
    for recorder in recorders:
        recorder.wait_for(what='a message before the pause')
    serve = _service('pause_physics', namespace, persistent=True)

    def counts():
        return [len(recorder.messages) for recorder in recorders]

    def is_still():
        before = counts()
        for _ in range(TURNS):
            serve()
        return counts() == before

    wait_until(is_still, TIMEOUT, 'a robot that is paused')
    serve.close()


def moves_on(truth, action):
    """Do something while a moving robot's time stands still; return for how long (s) it moves on.

    That is until it was last seen moving, so that a message that gets lost changes nothing.
    """
    paused = _pause_in_motion(truth)
    action()
    pause(truth)
    truth.clear()
    call('unpause_physics')
    truth.wait_for(lambda m: m.header.stamp.to_sec() > paused + WATCHED,
                   what=f'{WATCHED:g} s of the robot\'s time')
    return max((m.header.stamp.to_sec() - paused for m in truth.messages
                if not is_at_rest(m)), default=0.0)


def _pause_in_motion(truth):
    """Pause a robot while it moves; return when that is (s).

    Before it is paused a busy machine may let it stop, by its watchdog, and drive on.
    """
    def moves():
        call('unpause_physics')
        truth.wait_until_moving()
        pause(truth)
        return not is_at_rest(truth.last)

    wait_until(moves, TIMEOUT, 'a robot that moves')
    return truth.stamp


def _service(name, namespace, **options):
    full_name = f'{namespace}sim_turtlebot/{name}'
    rospy.wait_for_service(full_name, TIMEOUT * PATIENCE)
    return rospy.ServiceProxy(full_name, Empty, **options)

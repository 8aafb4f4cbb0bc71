"""Behaviours of nodes, each a function of the odometry."""

import math
from collections import defaultdict

from odometry_common.angles import wrap_to_pi

RIGHT_ANGLE = math.pi / 2


def remembering(step):
    """Return what makes a node of a function of a Pose, and of a memory with the `start` and the `last` one."""
    def make():
        memory = defaultdict(float)

        def answer(pose):
            memory.setdefault('start', pose)
            memory.setdefault('last', pose)
            found = step(memory, pose)
            memory['last'] = pose
            return found
        return answer
    return make


def driving(distance, speed=0.2):
    """Return a node that drives until a function of start and Pose says 2 m."""
    return remembering(lambda memory, pose: (speed if distance(memory['start'], pose) < 2.0 else 0.0, 0.0))


def turning(error, gain=0.5):
    """Return a node with a P-controller on a function of the yaw."""
    return lambda: lambda pose: (0.0, gain * error(pose.yaw))


def counting(step):
    """Return a detector that adds up a function of two Poses."""
    @remembering
    def add(memory, pose):
        memory['sum'] += step(memory['last'], pose)
        return memory['sum']
    return add


def way(start, pose):
    return math.hypot(pose.x - start.x, pose.y - start.y)


def error_of(yaw):
    return wrap_to_pi(RIGHT_ANGLE - yaw)


@remembering
def by_time(memory, pose):
    return (0.2 if 0.2 * (pose.time - memory['start'].time) < 2.0 else 0.0), 0.0


@remembering
def without_zero(memory, pose):
    return (0.2, 0.0) if way(memory['start'], pose) < 2.0 else None


@remembering
def once(memory, pose):
    return (0.1, 0.0) if pose is memory['start'] else None


@remembering
def turn_by(memory, pose):
    memory['turned'] += wrap_to_pi(pose.yaw - memory['last'].yaw)
    return 0.0, 0.5 * (RIGHT_ANGLE - memory['turned'])


@remembering
def wrong_derivative(memory, pose):
    last, memory['error'] = memory['error'], error_of(pose.yaw)
    return 0.0, max(-1.0, min(1.0, 0.8 * memory['error'] + 2.0 * (last - memory['error']) / 0.1))


@remembering
def narrow_window(memory, pose):
    memory['there'] = memory['there'] or abs(way(memory['start'], pose) - 2.0) < 0.0131
    return (0.0 if memory['there'] else 0.49), 0.0


@remembering
def drives_again(memory, pose):
    """Rest a second at 2 m, and drive on."""
    there = way(memory['start'], pose)
    if there >= 2.0 and pose.time - memory.setdefault('there', pose.time) < 1.0:
        return 0.0, 0.0
    return 0.2, 0.0


@remembering
def spins_at_the_goal(memory, pose):
    if way(memory['start'], pose) < 2.0:
        return 0.3, 0.0
    return 0.0, (1.0 if pose.time - memory.setdefault('there', pose.time) < 6.0 else 0.0)


@remembering
def rarely(memory, pose):
    """Command once in ten seconds."""
    if pose.time < memory['next'] - 1e-6:
        return None
    memory['next'] = pose.time + 10.0
    return (0.5 if way(memory['start'], pose) < 2.0 else 0.0), 0.0


@remembering
def place_by_speed(memory, pose):
    """Return the distance from the start by dead reckoning."""
    step = pose.linear * (pose.time - memory['last'].time)
    memory['x'] += step * math.cos(pose.yaw)
    memory['y'] += step * math.sin(pose.yaw)
    return math.hypot(memory['x'], memory['y'])


@remembering
def from_origin(memory, pose):
    memory['sum'] = memory.get('sum', math.hypot(pose.x, pose.y)) + way(memory['last'], pose)
    return memory['sum']


@remembering
def adds_displacements(memory, pose):
    memory['sum'] += way(memory['start'], pose)
    return memory['sum']


@remembering
def one_step(memory, pose):
    return way(memory['last'], pose)


@remembering
def while_moving(memory, pose):
    step = way(memory['last'], pose)
    memory['sum'] += step
    return memory['sum'] if step > 0.0005 else None


@remembering
def overshooting(memory, pose):
    """Drive more than 2.06 m, and come back."""
    there = way(memory['start'], pose)
    memory['beyond'] = memory['beyond'] or there > 2.06
    if not memory['beyond']:
        return 0.3, 0.0
    return (-0.1 if there > 2.01 else 0.0), 0.0


def rounded(last, pose):
    return math.hypot(round(pose.x, 2) - round(last.x, 2), round(pose.y, 2) - round(last.y, 2))

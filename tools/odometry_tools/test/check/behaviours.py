"""Behaviours of nodes, each a function of the odometry."""

import math

from odometry_common.angles import wrap_to_pi

RIGHT_ANGLE = math.pi / 2


def remembering(step):
    """Return what makes a node of a function of its memory (a dictionary, with `start`) and a Pose."""
    def make():
        memory = {}
        return lambda pose: step(memory if memory else memory.setdefault('start', pose) and memory, pose)
    return make


def driving(distance, speed=0.2):
    """Return a node that drives until a function of start and Pose says 2 m."""
    return remembering(lambda memory, pose: (speed if distance(memory['start'], pose) < 2.0 else 0.0, 0.0))


def turning(error, gain=0.5):
    """Return a node with a P-controller on a function of the yaw."""
    return lambda: lambda pose: (0.0, gain * error(pose.yaw))


def counting(step):
    """Return a detector that adds up a function of two Poses."""
    def add(memory, pose):
        memory['sum'] = memory.get('sum', 0.0) + step(memory.get('last', pose), pose)
        memory['last'] = pose
        return memory['sum']
    return remembering(add)


def way(start, pose):
    return math.hypot(pose.x - start.x, pose.y - start.y)


def by_time(memory, pose):
    return (0.2 if 0.2 * (pose.time - memory['start'].time) < 2.0 else 0.0), 0.0


def without_zero(memory, pose):
    return (0.2, 0.0) if way(memory['start'], pose) < 2.0 else None


def once(memory, _pose):
    return None if 'sent' in memory else memory.setdefault('sent', (0.1, 0.0))


def to_point(memory, pose):
    dx, dy = 2.0 - pose.x, -pose.y
    memory['there'] = memory.get('there') or math.hypot(dx, dy) < 0.02
    error = wrap_to_pi(math.atan2(dy, dx) - pose.yaw)
    return (0.0, 0.0) if memory['there'] else (0.2 if abs(error) < 0.3 else 0.0, error)


def turn_by(memory, pose):
    memory['turned'] = memory.get('turned', 0.0) + wrap_to_pi(pose.yaw - memory.get('last', pose).yaw)
    memory['last'] = pose
    return 0.0, 0.5 * (RIGHT_ANGLE - memory['turned'])


def wrong_derivative(memory, pose):
    error = wrap_to_pi(RIGHT_ANGLE - pose.yaw)
    last, memory['error'] = memory.get('error', 0.0), error
    return 0.0, max(-1.0, min(1.0, 0.8 * error + 2.0 * (last - error) / 0.1))


def turn_by_time(memory, pose):
    error = wrap_to_pi(RIGHT_ANGLE - memory['start'].yaw)
    return 0.0, math.copysign(0.3, error) if pose.time - memory['start'].time < abs(error) / 0.3 else 0.0


def narrow_window(memory, pose):
    memory['there'] = memory.get('there') or abs(way(memory['start'], pose) - 2.0) < 0.0131
    return (0.0 if memory['there'] else 0.49), 0.0


def rest_between(memory, pose):
    there = way(memory['start'], pose)
    if there > 1.0 and pose.time - memory.setdefault('half', pose.time) < 5.0:
        return 0.0, 0.0
    return (0.2 if there < 2.0 else 0.0), 0.0


def drives_again(memory, pose):
    """Rest a second at 2 m, and drive them once more."""
    there = way(memory['start'], pose)
    if there >= 2.0 and pose.time - memory.setdefault('there', pose.time) < 1.0:
        return 0.0, 0.0
    return (0.2 if there < 4.0 else 0.0), 0.0


def spins_at_the_goal(memory, pose):
    if way(memory['start'], pose) < 2.0:
        return 0.3, 0.0
    return 0.0, (1.0 if pose.time - memory.setdefault('there', pose.time) < 6.0 else 0.0)


def rarely(memory, pose):
    """Command once in ten seconds."""
    if pose.time < memory.get('next', 0.0) - 1e-6:
        return None
    memory['next'] = pose.time + 10.0
    return (0.3 if way(memory['start'], pose) < 2.0 else 0.0), 0.0


def place_by_speed(memory, pose):
    """Return the distance from the start by dead reckoning."""
    last, memory['last'] = memory.get('last', pose), pose
    step = pose.linear * (pose.time - last.time)
    memory['x'] = memory.get('x', 0.0) + step * math.cos(pose.yaw)
    memory['y'] = memory.get('y', 0.0) + step * math.sin(pose.yaw)
    return math.hypot(memory['x'], memory['y'])


def silent_halfway(memory, pose):
    return (0.2, 0.0) if way(memory['start'], pose) < 1.0 else None


def from_origin(memory, pose):
    last = memory.get('last')
    memory['sum'] = memory.get('sum', 0.0) + (way(last, pose) if last else math.hypot(pose.x, pose.y))
    memory['last'] = pose
    return memory['sum']


def one_step(memory, pose):
    last, memory['last'] = memory.get('last', pose), pose
    return way(last, pose)


def once_a_second(memory, pose):
    memory['sum'] = one_step(memory, pose) + memory.get('sum', 0.0)
    if pose.time < memory.get('next', 0.0) - 1e-6:
        return None
    memory['next'] = pose.time + 1.0
    return memory['sum']


def while_moving(memory, pose):
    step = one_step(memory, pose)
    memory['sum'] = memory.get('sum', 0.0) + step
    return memory['sum'] if step > 0.0005 else None


def overshooting(memory, pose):
    """Drive more than 2.06 m, and come back."""
    memory['beyond'] = memory.get('beyond') or way(memory['start'], pose) > 2.06
    if not memory['beyond']:
        return 0.3, 0.0
    return (-0.1 if way(memory['start'], pose) > 2.01 else 0.0), 0.0


def rounded(last, pose):
    return math.hypot(round(pose.x, 2) - round(last.x, 2), round(pose.y, 2) - round(last.y, 2))


def fixed_time(memory, pose):
    """Take 0.05 s for the time between two messages."""
    memory['sum'] = memory.get('sum', 0.0) + 0.05 * pose.linear
    return (0.25 if memory['sum'] < 2.0 else 0.0), 0.0


def heading_to_360(yaw):
    return RIGHT_ANGLE - yaw % (2 * math.pi)

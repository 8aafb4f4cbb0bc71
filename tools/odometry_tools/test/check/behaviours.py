"""Behaviours of nodes, each a function of the odometry, with the verdicts and hints that they get."""

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


EVERYWHERE = 'plain', 'moved_start', 'odom_5hz', 'slow_base'
ON_THE_ROUTE = 'route', *EVERYWHERE[1:]
# The node, and the rule and hint of the scenarios that are not passed.
CASES = {
    'two_meters': {
        'right': (driving(way), {}),
        'right, fast': (driving(way, 1.0), {}),
        'right, with a rest': (remembering(rest_between), {}),
        'right, overshoots': (remembering(overshooting), {}),
        'fixed time': (remembering(fixed_time), {'odom_5hz': 'passed_by slow_odometry'}),
        'position': (driving(lambda start, pose: pose.x), {'moved_start': 'all_zero start'}),
        'one axis': (driving(lambda start, pose: abs(pose.x - start.x)), {'moved_start': 'late one_axis'}),
        'sum': (driving(lambda start, pose: abs(pose.x - start.x) + abs(pose.y - start.y)),
                {'moved_start': 'early sum_of_axes'}),
        'from the origin': (driving(lambda start, pose: math.hypot(pose.x, pose.y) - math.hypot(start.x, start.y)),
                            {'moved_start': 'passed_by start'}),
        'a point': (remembering(to_point), {'moved_start': 'early place'}),
        'squares': (driving(lambda start, pose: way(start, pose)**2), dict.fromkeys(EVERYWHERE, 'early')),
        'early': (driving(lambda start, pose: way(start, pose) + 0.1), dict.fromkeys(EVERYWHERE, 'early')),
        'equality': (remembering(lambda memory, pose: (0.3, 0.0)), dict.fromkeys(EVERYWHERE, 'passed_by')),
        'window': (remembering(narrow_window), {'odom_5hz': 'passed_by slow_odometry'}),
        'time': (remembering(by_time), {'slow_base': 'early open_loop'}),
        'no zero': (remembering(without_zero), dict.fromkeys(EVERYWHERE, 'ceased no_zero')),
        'once': (remembering(once), dict.fromkeys(EVERYWHERE, 'ceased one_command')),
        'zero': (lambda: lambda pose: (0.0, 0.0), dict.fromkeys(EVERYWHERE, 'all_zero')),
        'creeps': (driving(way, 0.004), dict.fromkeys(EVERYWHERE, 'unfinished')),
        'turns': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw)), dict.fromkeys(EVERYWHERE, 'only_turned'))},
    'heading': {
        'right': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw)), {}),
        'not wrapped': (turning(lambda yaw: RIGHT_ANGLE - yaw), {'moved_start': 'long_way not_wrapped'}),
        'to 360': (turning(heading_to_360), {'slow_base': 'long_way not_wrapped'}),
        'sign': (turning(lambda yaw: wrap_to_pi(yaw - RIGHT_ANGLE)), dict.fromkeys(EVERYWHERE, 'rings sign')),
        'degrees': (turning(lambda yaw: 90 - yaw), dict.fromkeys(EVERYWHERE, 'long_way degrees')),
        'orientation.z': (turning(lambda yaw: RIGHT_ANGLE - math.sin(yaw / 2)),
                          dict.fromkeys(EVERYWHERE, 'long_way quaternion')),
        'asin': (turning(lambda yaw: RIGHT_ANGLE - math.asin(math.sin(yaw))), {'moved_start': 'long_way half_circle'}),
        'without sign': (turning(lambda yaw: abs(wrap_to_pi(RIGHT_ANGLE - yaw))),
                         {'moved_start': 'long_way half_circle'}),
        'gain of 9': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw), 9.0), {'odom_5hz': 'long_way gain_high'}),
        'wrong derivative': (remembering(wrong_derivative),
                             dict.fromkeys(('plain', 'moved_start', 'odom_5hz'), 'rings')),
        'by': (remembering(turn_by), dict.fromkeys(('moved_start', 'slow_base'), 'elsewhere turns_by')),
        'time': (remembering(turn_by_time), {'slow_base': 'elsewhere open_loop'}),
        'chatter': (turning(lambda yaw: math.copysign(1.0, wrap_to_pi(RIGHT_ANGLE - yaw))),
                    dict.fromkeys(EVERYWHERE, 'rings')),
        'high gain': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw), 10.0), {'odom_5hz': 'rings gain_high'}),
        'low gain': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw), 0.01),
                     dict.fromkeys(EVERYWHERE, 'unfinished gain_low')),
        'equality': (lambda: lambda pose: (0.0, 0.5), dict.fromkeys(EVERYWHERE, 'long_way')),
        'drives': (driving(way), dict.fromkeys(EVERYWHERE, 'only_drove'))},
    'moved_distance': {
        'right': (counting(way), {}),
        'right, by speed': (counting(lambda last, pose: abs(pose.linear) * (pose.time - last.time)), {}),
        'right, once a second': (remembering(once_a_second), {}),
        'right, while it moves': (remembering(while_moving), {}),
        'kilometres': (counting(lambda last, pose: way(last, pose) / 1000),
                       dict.fromkeys(ON_THE_ROUTE, 'miscounted')),
        'never': (lambda: lambda pose: 0.0, dict.fromkeys(ON_THE_ROUTE, 'miscounted')),
        'displacement': (remembering(lambda memory, pose: way(memory['start'], pose)),
                         dict.fromkeys(ON_THE_ROUTE, 'displacement')),
        'one axis': (counting(lambda last, pose: abs(pose.x - last.x)),
                     dict.fromkeys(ON_THE_ROUTE, 'miscounted one_axis')),
        'sum': (counting(lambda last, pose: pose.x - last.x + pose.y - last.y),
                dict.fromkeys(ON_THE_ROUTE, 'miscounted sum_of_axes')),
        'rounded': (counting(rounded), {'route': 'miscounted rounded', 'moved_start': 'miscounted rounded',
                                        'slow_base': 'miscounted rounded'}),
        'squares': (counting(lambda last, pose: way(last, pose)**2),
                    dict.fromkeys(ON_THE_ROUTE, 'miscounted squares')),
        'backwards': (counting(lambda last, pose: pose.linear * (pose.time - last.time)),
                      dict.fromkeys(ON_THE_ROUTE, 'miscounted backwards')),
        'fixed time': (counting(lambda last, pose: abs(pose.linear) * 0.05), {'odom_5hz': 'miscounted fixed_dt'}),
        'twice': (counting(lambda last, pose: 2 * way(last, pose)), dict.fromkeys(ON_THE_ROUTE, 'miscounted times')),
        'from zero': (remembering(from_origin), {'moved_start': 'miscounted from_origin'}),
        'one step': (remembering(one_step), dict.fromkeys(ON_THE_ROUTE, 'miscounted last_step'))}}

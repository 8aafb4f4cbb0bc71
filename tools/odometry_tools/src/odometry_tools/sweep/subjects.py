"""The subject of a sweep: a tutorial, without ROS, or a user's launch file, in lockstep."""

import difflib
import itertools
import re
from typing import NamedTuple

from odometry_common.parameters import Parameter, StartError
from sim_turtlebot.settings import PARAMETERS

from odometry_tools.runs.tutorials import TUTORIALS
from odometry_tools.sweep import closed_loop
from odometry_tools.sweep.results import METRICS

LAUNCH = 'launch'  # in place of a tutorial
LAUNCH_ARGUMENT = 'launch:'  # before the name of an argument that names a column already
UNTIL = Parameter('until', 10.0, '', 's of simulated time', 'from 0.05 to 100000')
# The sweep controls time, opens no window, and sets the seed of each run.
NOT_SET = {'gui', 'robots', 'real_time_factor', 'lockstep', 'paused', 'seed'}
# Parameters for wall time, tf, scans, late messages, and nodes that wait, compute or exit.
NEEDS_ROS = {'clock_rate', 'timeout', 'exit_when_done', 'tolerance', 'scan', 'scan_rate',
             'scan_beams', 'scan_fov', 'scan_range_min', 'scan_range_max', 'scan_noise',
             'publish_tf', 'cpu_budget'}
ROBOT = {row.name[1:]: row for row in PARAMETERS.rows}
AS_IT_IS = re.compile(r'\S(.*\S)?')  # how roslaunch passes a value unchanged
TAKEN = {*ROBOT, *METRICS[LAUNCH], 'run', 'ended'}


class Tutorial(NamedTuple):
    """A tutorial; its fields are lines of a campaign file."""

    tutorial: str

    kind = name = property(lambda self: self.tutorial)
    jobs_per_processor = 1

    def checked(self, values):
        """Return this; raise StartError if it cannot run with these values: lists by parameter."""
        tutorial = choose(self.kind, TUTORIALS, f'there is no tutorial {self.kind!r}')
        rows = {**{row.name[1:]: row for row in tutorial.PARAMETERS}, **ROBOT}
        _check_values(self, values, rows, NEEDS_ROS)
        return self

    def run(self, parameters):
        """Run without ROS; return the metrics by name."""
        return closed_loop.run(self.kind, parameters)


class Launched(NamedTuple):
    """A launch file, and when its runs end; its fields are lines of a campaign file."""

    launch: list  # package and name
    until: float  # s of simulated time

    kind = LAUNCH
    jobs_per_processor = 2  # half of a run is waiting, for its nodes to start and to end
    name = property(lambda self: self.launch[1])

    def checked(self, values):
        """Return this with a number as `until`; StartError as for Tutorial.checked()."""
        from roslaunch.arg_dump import get_args

        from odometry_tools.runs.launch_files import path_of, refused
        until = UNTIL.check(self.until)
        is_pair = isinstance(self.launch, list) and [*map(type, self.launch)] == [str, str]
        if not is_pair:
            raise StartError(f'launch is {self.launch!r}, but must be [package, file]')
        with refused(self.name):
            path = path_of(*self.launch)
            names = get_args([path])
        arguments = [f'{LAUNCH_ARGUMENT}{name}' if name in TAKEN else name for name in names]
        _check_values(self, values, {**dict.fromkeys(arguments), **ROBOT})
        _check_text({name: values[name] for name in values if name not in ROBOT})
        first = {name: several[0] for name, several in values.items()}
        others = [{**first, name: value} for name in values if name not in ROBOT
                  for value in values[name][1:]]
        for parameters in [first, *others]:
            self._check_nodes(path, parameters)
        return self._replace(until=until)

    def _check_nodes(self, path, parameters):
        """Raise StartError if a node of the launch file cannot run beside the robot."""
        from roslaunch.node_args import create_local_process_args

        from odometry_tools.runs.launch_files import nodes_beside_robot, refused
        *_, arguments = self.nodes(parameters)
        nodes = nodes_beside_robot(path, [f'{name}:={value}' for name, value in arguments.items()])
        if not nodes:
            raise StartError(f'{self.name} starts no node')
        for node in nodes:
            program = f'{self.name}: node {node.name}, {node.package}/{node.type}'
            with refused(program):
                create_local_process_args(node, None)
            if node.machine_name:
                raise StartError(
                    f'{program}, is for the machine {node.machine_name}, where the robot is not')
            if 'ROS_MASTER_URI' in dict(node.env_args):
                raise StartError(
                    f'{program}, has a ROS_MASTER_URI of its own, where the robot is not')

    def run(self, parameters):
        """Run beside a robot in lockstep; return the metrics by name."""
        from odometry_tools.sweep.session_process import run_in_session
        return run_in_session(self, parameters)

    def nodes(self, parameters):
        """Return package, name and arguments of the launch file, as roslaunch reads them."""
        return (*self.launch, {name.replace(LAUNCH_ARGUMENT, '', 1):
                               str(value).lower() if isinstance(value, bool) else value
                               for name, value in parameters.items() if name not in ROBOT})


def _check_text(values):
    """Raise StartError for an argument that roslaunch would cut, or replace by its default."""
    for name, several in values.items():
        for value in map(str, several):
            if ':=' in value or not AS_IT_IS.fullmatch(value):
                raise StartError(
                    f'{name} is {value!r}, but roslaunch passes no value that is empty, '
                    'has := or a line end, or begins or ends with a space')


def _check_values(subject, values, known, left_out=frozenset()):
    """Check each value, and each combination of the robot's.

    :param known: Parameters by name; None for what may have any value
    :raises ParameterError: for the first value that is not allowed
    :raises StartError: for a name that is not known
    """
    known = {name: row for name, row in known.items() if name not in NOT_SET | left_out}
    robot = PARAMETERS.read({name: several[0] for name, several in values.items()})
    for name, several in values.items():
        row = choose(name, known, f'parameter {name} cannot be set in a sweep of {subject.name}')
        for value in several if row else ():
            row.check(value, robot)
    # The range of one may depend on another.
    linked = {
        name: several for name, several in values.items()
        if name in ROBOT}
    for combination in itertools.product(*linked.values()):
        PARAMETERS.read(dict(zip(linked, combination)))


def choose(name, known, complaint):
    """Return known[name]; without one raise StartError: the complaint, and what may be meant."""
    if name not in list(known):
        similar = difflib.get_close_matches(str(name), known, 1, cutoff=0.8)
        hint = f'did you mean {similar[0]}?' if similar else f'there is {", ".join(sorted(known))}'
        raise StartError(f'{complaint}: {hint}')
    return known[name]

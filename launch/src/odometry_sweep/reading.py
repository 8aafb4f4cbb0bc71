"""The parameters of a run: those of a tutorial's nodes and of the simulated robot."""

from odometry_common.parameters import ParameterError, StartError, read_from
from sim_turtlebot.building import new_simulation
from sim_turtlebot.settings import read_settings
from sim_turtlebot.world_file import WorldFileError

from odometry_sweep.tutorials import TUTORIALS

# Of windows, wall time, scans, messages that are late, and nodes that wait or end.
WITHOUT_MEANING = {'gui', 'robots', 'clock_rate', 'real_time_factor', 'lockstep',
                   'paused', '/use_sim_time', 'timeout', 'exit_when_done',
                   'tolerance', 'scan', 'scan_rate', 'scan_beams', 'scan_fov', 'scan_range_min',
                   'scan_range_max', 'scan_noise'}


def read(tutorial, values):
    """Return a tutorial's part and the robot's settings for parameter values by their names.

    :raises ParameterError: if a node would refuse one of them
    """
    with read_from(values):
        return TUTORIALS[tutorial](), read_settings()


def known_names(tutorial):
    """Return the names of the parameters that can be set."""
    with read_from({}) as asked:
        TUTORIALS[tutorial]()
        read_settings()
    return sorted(asked - WITHOUT_MEANING - {'seed'})


def check_names(tutorial, names):
    """Raise StartError, with one line for the user, if one of them cannot be set."""
    known = known_names(tutorial)
    for name in names:
        if name == 'seed':
            raise StartError('parameter seed is set for each run: say how many there are to be')
        if name in WITHOUT_MEANING:
            raise StartError(f'parameter {name} means nothing in a run without ROS, windows and '
                             'wall time')
        if name not in known:
            raise StartError(f'unknown parameter {name}; {tutorial} has {", ".join(known)}')


def check_values(tutorial, values):
    """Raise ParameterError if values by their names cannot be run with."""
    part, settings = read(tutorial, values)
    if tutorial == 'rotate':
        _check_rate(part.rate, settings.odom_rate)
    if settings.world:
        try:
            new_simulation(settings)
        except WorldFileError as error:
            raise ParameterError('~world', settings.world, error) from None


def _check_rate(rate, odom_rate):
    """Refuse a rate at which the controller and a robot in lockstep would miss each other."""
    share = odom_rate / rate
    if round(share) < 1 or abs(share - round(share)) > 1e-9:
        raise ParameterError('~rate', rate, f'~odom_rate, {odom_rate:g} Hz, divided by a whole '
                             'number, in lockstep')

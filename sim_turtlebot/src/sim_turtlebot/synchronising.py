"""What the simulation waits for between two ticks: every node, or none."""

from odometry_common.parameters import StartError


class FreeRunning:
    """Waits for no node; the methods are those of Lockstep that the simulator calls."""

    def wait(self, only_clock=False):
        """Return at once."""

    def check_senders(self, arrivals, now, unprompted):
        """Name nobody: a node may send at any time."""

    def is_graph_stable(self, stable_time=0.0):
        """Time may begin at once."""
        return True

    def forget_reports(self):
        """There are none."""


def synchronise(settings):
    """Return a Lockstep, or a FreeRunning without ~lockstep."""
    if not settings.lockstep:
        return FreeRunning()
    try:  # here, since this import takes a tenth of the start
        from sim_turtlebot.lockstep.lockstep import Lockstep
    except ModuleNotFoundError as error:
        raise StartError(f'lockstep needs {error.name}: install python3-{error.name}') from None
    return Lockstep(1 / settings.clock_rate, settings.cpu_budget)

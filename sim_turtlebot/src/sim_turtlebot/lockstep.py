"""Lockstep: the simulation waits for controllers that have not answered."""


class Lockstep:
    """Keeps the simulation from passing a multiple of 1/rate before a command of each controller.

    A controller that has never sent one, or no longer does, is not waited for; when it sends one
    (again), it is in step from the next multiple on.
    """

    def __init__(self, rate, step_rate, controllers):
        """Wait at `rate` (Hz) in steps of 1/step_rate for this many controllers."""
        self._steps_between = step_rate / rate
        self._controllers = range(controllers)
        self._in_step = set()
        self.restart()

    def restart(self):
        """Begin again at time zero."""
        self._wait_at(0, self._controllers)

    @property
    def started(self):
        """Whether any controller has ever sent a command."""
        return bool(self._in_step)

    def is_owed_an_answer(self, steps):
        """Return whether, after so many steps, a controller that is in step has yet to command."""
        return steps >= self.last_step and bool(self._awaited & self._in_step)

    def heard(self, controller):
        """Note a command from a controller (an index)."""
        self._in_step.add(controller)
        self._awaited.discard(controller)

    def must_wait(self, steps):
        """Return whether the step after so many has to wait for a command."""
        if steps < self.last_step:
            return False
        if self._awaited:
            return True
        self._wait_at(self._multiple + 1, self._in_step)
        return False

    def give_up(self):
        """Go on without those awaited; return whether one of them used to be in step."""
        lost = bool(self._awaited & self._in_step)
        self._in_step -= self._awaited
        self._awaited.clear()
        return lost

    def _wait_at(self, multiple, controllers):
        self._multiple = multiple
        self._awaited = set(controllers)
        # The last step that may be reached without asking must_wait() again. The small term keeps
        # a multiple that falls on a step from being rounded off it.
        self.last_step = int(multiple * self._steps_between + 1e-6)

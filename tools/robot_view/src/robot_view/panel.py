"""The panel: the robot's state in numbers, and the buttons for the simulation."""

import html

import rospy
from std_srvs.srv import Empty

from robot_view.robots import SERVICES

NOTICE_SECONDS = 10
ROWS = [  # name, label, decimals, unit
    ('moved_distance', 'moved distance', 3, ' m'), ('true_distance', 'true path', 3, ' m'),
    ('true_from_start', 'true distance from the start', 3, ' m'),
    ('speed', 'speed', 2, ' m/s'), ('heading', 'heading', 1, '°'),
    ('simulated_time', 'simulated time', 1, ' s'), ('real_time_factor', 'real-time factor', 2, '')]


class Readings:
    """A table of measured values."""

    def __init__(self, gui):
        self._html = gui.add_html('')
        self.show({})

    def show(self, values):
        """Show the known values, by their names in ROWS; `true_since` (s) goes beside the label."""
        since = values.get('true_since')
        notes = {'true_distance': '' if since is None else f' since {since:.1f} s'}
        rows = []
        for name, label, decimals, unit in ROWS:
            if values.get(name) is not None:
                # Adding zero turns -0.0 into 0.0.
                value = f'{round(values[name], decimals) + 0.0:.{decimals}f}{unit}'
                rows.append(f'<tr><td>{label}{notes.get(name, "")}</td>'
                            f'<td id="{name}">{value}</td></tr>')
        self._html.content = f'<table id="readings">{"".join(rows)}</table>'


class SimulationButtons:
    """A status line, and the buttons that call the simulator's services."""

    def __init__(self, gui, robots):
        self._robots = robots
        self._status = gui.add_html('')
        self._buttons = gui.add_button_group('simulation', tuple(SERVICES), visible=False)
        self._buttons.on_click(self._call)

    def update(self):
        """Show the buttons if there is a simulator, and the complaint if there is one."""
        self._buttons.visible = is_simulated = self._robots.is_simulated
        complaint = self._robots.complaint
        if not complaint and not is_simulated:
            complaint = 'no simulator here: no pause, resume and reset'
        self._status.content = f'<div id="status">{html.escape(complaint)}</div>'

    def _call(self, event):
        button = event.target.value
        if button not in SERVICES:
            return
        try:
            rospy.ServiceProxy(SERVICES[button], Empty)()
            if button == 'reset':
                for monitor in self._robots.monitors.values():
                    monitor.reset_distance()
        except rospy.ServiceException as error:
            event.client.add_notification(button, str(error), auto_close_seconds=NOTICE_SECONDS)


def add_placing(gui, put):
    """Add an input for a pose, and a button that places a simulated robot there, at rest.

    :param put: function of x, y (m) and heading (degrees)
    :return: their folder, hidden
    """
    folder = gui.add_folder('put the robot', expand_by_default=False, visible=False)
    with folder:
        pose = gui.add_vector3('x, y (m), heading (degrees)', (0.0, 0.0, 0.0))
        gui.add_button('put here').on_click(lambda _: put(*pose.value))
    return folder

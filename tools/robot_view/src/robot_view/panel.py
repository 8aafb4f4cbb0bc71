"""The panel: the robot's state in numbers, and the buttons for the simulation."""

import html
import math

import rospy
from std_srvs.srv import Empty

from robot_view.robots import SERVICES

NOTICE_SECONDS = 10
TABLE = '<table id="readings">{}</table>'


class Readings:
    """A table of measured values."""

    def __init__(self, gui):
        self._html = gui.add_html(TABLE.format(''))

    def show(self, robot):
        """Show what is known of a RobotMonitor."""
        state, trace = robot.odometry, robot.trace
        since, start = '', ' from the start'
        if trace.since is not None:
            since = start = f' since {trace.since:.1f} s'
        rows = []
        for name, label, value, decimals, unit in (
                ('moved_distance', 'moved distance', robot.moved, 3, ' m'),
                ('true_distance', f'true path{since}', trace.true_distance, 3, ' m'),
                ('true_from_start', f'true distance{start}', trace.true_from_start, 3, ' m'),
                ('speed', 'speed', state.speed, 2, ' m/s'),
                ('heading', 'heading', math.degrees(state.planar.yaw), 1, '°'),
                ('simulated_time', 'simulated time', robot.simulated_time, 1, ' s'),
                ('real_time_factor', 'real-time factor', robot.real_time_factor(), 2, '')):
            if value is not None:
                # Adding zero turns -0.0 into 0.0.
                text = f'{round(value, decimals) + 0.0:.{decimals}f}{unit}'
                rows.append(f'<tr><td>{label}</td><td id="{name}">{text}</td></tr>')
        self._html.content = TABLE.format(''.join(rows))


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
        pose = gui.add_vector3('x, y (m), heading (degrees)', (0.0, 0.0, 0.0), step=0.01)
        gui.add_button('put here').on_click(lambda _: put(*pose.value))
    return folder

"""The panel: the robot's state in numbers, and buttons for the simulation."""

import html

import rospy
from std_srvs.srv import Empty

NODE = 'sim_turtlebot'
WARNING = f'{NODE}/warning'
SERVICES = {'pause': f'{NODE}/pause_physics', 'resume': f'{NODE}/unpause_physics',
            'reset': f'{NODE}/reset_simulation'}
ROWS = [  # name, label, decimals, unit
    ('moved_distance', 'moved distance', 3, ' m'), ('true_distance', 'true distance', 3, ' m'),
    ('speed', 'speed', 2, ' m/s'), ('heading', 'heading', 1, '°'),
    ('simulated_time', 'simulated time', 1, ' s'), ('real_time_factor', 'real-time factor', 2, '')]
STYLE = ('<style>#readings{width:100%;font-size:0.95em;padding:0 0.8em}'
         '#readings td+td{text-align:right;font-weight:600;font-variant-numeric:tabular-nums}'
         '#status{padding:0 1em 0.6em;font-size:0.85em;color:#b05010}</style>')


class Readings:
    """A table of measured values."""

    def __init__(self, gui):
        """Add it."""
        self._html = gui.add_html('')
        self.show({})

    def show(self, values):
        """Show values by the names in ROWS; one that is missing or None is a dash."""
        rows = ''.join(
            f'<tr><td>{label}</td><td id="{name}">{_format(values.get(name), *form)}</td></tr>'
            for name, label, *form in ROWS)
        self._html.content = f'{STYLE}<table id="readings">{rows}</table>'


class SimulationButtons:
    """Buttons that call the simulator's services."""

    def __init__(self, gui):
        """Add them."""
        self._status = gui.add_html('')
        self._buttons = gui.add_button_group('simulation', tuple(SERVICES), visible=False)
        self._buttons.on_click(self._call)

    def update(self, services, complaint=''):
        """Offer the services (full names) that there are, and say what is wrong, if anything is.

        :return: whether they are a simulator's
        """
        names = {rospy.resolve_name(name) for name in SERVICES.values()}
        self._buttons.visible = names <= services
        if not complaint and not self._buttons.visible:
            complaint = 'no simulator here: no pause, resume and reset'
        self._status.content = f'<div id="status">{html.escape(complaint)}</div>'
        return self._buttons.visible

    @staticmethod
    def _call(event):
        try:
            rospy.ServiceProxy(SERVICES[event.target.value], Empty)()
        except rospy.ServiceException as error:
            event.client.add_notification(event.target.value, str(error), auto_close_seconds=10)


def _format(value, decimals, unit):
    # Adding zero takes the sign from a zero.
    return '–' if value is None else f'{round(value, decimals) + 0.0:.{decimals}f}{unit}'

"""What one browser looks at: the robot that it follows, or everything."""

from robot_view.camera import look_at_all, look_at_robot, shows
from robot_view.scene import WORLD


class ClientView:
    """The camera of one browser, and its checkbox and button, which no other browser has."""

    def __init__(self, client, order, find_places):
        """Follow the chosen robot, or show all if its start would be out of the picture.

        :param client: viser.ClientHandle
        :param order: position in the panel; the checkbox and the button come after it
        :param find_places: function that returns x, y (m) in the world of the chosen robot, of its
            start, and of all that there is to show
        """
        self._camera, self._find_places = client.camera, find_places
        self._aspect = None  # of the picture for which all was shown
        robot, start, *_ = find_places() or [(0.0, 0.0)] * 2
        # From the robot, as the page is opened, until all has been shown.
        self._start = start[0] - robot[0], start[1] - robot[1]
        self._world = client.scene.add_frame(WORLD, show_axes=False)
        self._follows = client.gui.add_checkbox('follow', True, hint='the chosen robot',
                                                order=order + 0.1)
        self._follows.on_update(self._on_follow)
        show_all_button = client.gui.add_button('show all', color='gray', order=order + 0.2)
        show_all_button.on_click(lambda _: self.show_all())

    def follow(self, x, y):
        """Follow the robot at x, y (m), or show all, again if the picture's aspect has changed.

        It changes once the panel of a new page is laid out, and when you fold a phone's panel.
        """
        if not (self._camera.image_height and self._camera.image_width):
            return  # a page that shows no picture
        if self._follows.value and shows(self._camera, self._start):
            self._world.position = (-x, -y, 0.0)
        elif self._follows.value or self._aspect not in (None, self._camera.aspect):
            self.show_all()

    def show_all(self):
        """Show paths, targets and robots, and follow none."""
        self._start = 0.0, 0.0  # before a click on the box lets follow() run again
        self._follows.value = False
        self._aspect = self._camera.aspect
        x, y, _ = self._world.position
        places = [(x + place[0], y + place[1]) for place in self._find_places()]
        if places:
            look_at_all(self._camera, places, self._aspect)

    def _on_follow(self, _):
        if self._follows.value:
            self._aspect = None
            look_at_robot(self._camera)

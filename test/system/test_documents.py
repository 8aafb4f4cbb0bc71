"""Every command that the documents show, typed as it is shown; what they print is compared in form.

A command that is added to a document is covered at once. If its reader has something running
already, or it cannot be run here, the tables below are the place to say so.
"""

import os
import re
import shlex
import shutil
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack

import pytest
import rosbag
import rospy
from documents import read_commands
from odometry_tests.messages import odometry
from odometry_tests.processes import hold_port
from odometry_tests.screen import virtual_screen
from odometry_tests.scripts import DOCUMENTS, ROOT
from reader import Reader

NOETIC = [f'. {file}' for file in ('/opt/ros/noetic/setup.bash',) if os.path.exists(file)]
# What is done already when a reader comes to a heading.
BEFORE = {'What the packages need': NOETIC,
          'Two machines': ['roscore', 'rosrun sim_turtlebot sim_turtlebot_node.py']}
TUTORIALS, LAUNCHES = 'README.md: The tutorials', 'README.md: All at once'
SIMULATIONS = 'docs/simulator.md: Many robots, any world'
WORKSPACE = 'docs/workspace.md: What the packages need'
SCAN = 'docs/scan.md: See the wall'
REAL_ROBOT = 'docs/real_robot.md: Two machines'
CALIBRATION = 'docs/calibration.md: A robot with errors'
# Where a reader goes on with what is running, by heading or by single command.
GOES_ON = {
    'Has the robot moved one metre?': TUTORIALS,
    'Rotate the robot to a heading': TUTORIALS,
    'By hand': TUTORIALS,
    'rosrun robot_view view.py': TUTORIALS,
    'Drive up to it': SCAN,
    'Drive the robot': REAL_ROBOT,
    'Its odometry': REAL_ROBOT,
    'The picture of a run': REAL_ROBOT,
    'Two metres': CALIBRATION,
    'Ten turns': CALIBRATION,
    'Drive again': CALIBRATION,
    'Drive to a goal': 'docs/navigation.md: Make a map',
    'Troubleshooting': LAUNCHES,
    'How to remove it': LAUNCHES,
    'Reference': LAUNCHES,
    'On a network': LAUNCHES,
    'Lockstep': SIMULATIONS,
    'Clone and build': WORKSPACE,
    'Drive in that workspace': WORKSPACE,
}
OUTSIDE_THE_SHELL = ['What the packages need']
# Words that a reader replaces by his own.
PLACEHOLDERS = {'REPOSITORY': shlex.quote(str(ROOT)), 'BAG': '~/run.bag',
                'NODE': 'sim_turtlebot', 'NAME': 'test_endings', '192.168.1.10': '127.0.0.1'}
# Of the figures of the bench, in its order.
PRINTED = 'demo lockstep robot start unpaced'
OUR_PACKAGES = shlex.quote(str(ROOT)) + '/.venv/lib/*/site-packages'
# What takes too long here, or would be in the way of others: what is typed in its place.
IN_PLACE = [
    (r'^roscore$', r'\g<0> -p "${ROS_MASTER_URI##*:}"', 'the usual port may be taken'),
    (r' view:=true\b', r'\g<0> view_port:=$PAGE_PORT', 'the usual port may be taken'),
    (r'view\.py$', r'\g<0> _port:=$PAGE_PORT', 'the usual port may be taken'),
    (r'^git clone .* && cd .*', rf'cd ~ && \g<0> && cd {shlex.quote(str(ROOT))}',
     'is set up already'),
    (r'^ROS_MASTER_URI=\S+ ', '', 'the robot is played here'),
    (r'^(\w+=\w+ )?\./ws test\b[^#]*', r'\g<0> --help ', 'is what runs this test'),
    (r'^(\./ws bench)$', rf'\1 {PRINTED} --runs 1 --window 0.1', 'takes ten minutes'),
    (r'^(\./ws sweep .*--seeds) \d+', r'\1 2', 'takes minutes'),
    (r'^\./ws python3 test/tools/\S+', r'\g<0> --help', 'changes the documents'),
    (r'^sudo apt (install|autoremove)', r'apt-get --simulate \1', 'is in the way of others'),
    (r'^CFLAGS=\S+ pip install .*',
     rf'ls -d {OUR_PACKAGES} >"$(echo ~/ros_python/lib/*/site-packages)/ours.pth"',
     'needs the network'),
    (r'^sudo apt-mark', 'apt-mark --simulate', 'is in the way of others'),
]
NOT_HERE = {
    r'turtlebot_bringup|turtlebot_teleop|cmd_vel_mux': 'is on the robot',
    r'^\./ws rostest one_metre ': 'is for test_example_workflow',
    r'^ssh\b': 'there is no other machine',
    r'^rosnode kill$': 'names a command, not a node',
    r'^rosnode kill -a$': 'would end what the reader goes on with',
    r'^rqt_plot ': 'Debian has no rqt',
    r'^rosrun teleop_twist_keyboard ': 'its package is not here',
    r'^(sudo )?rosdep |^sudo apt update$': 'needs the network',
    r'^(docker|podman) ': 'test_container types them',
    r'^\./ws sweep (one_metre |--campaign (\.ws|launch)/)': 'is of a package that is not here; test_sweep_launch has it',
    r'^\./ws sweep --replay ': 'is of a sweep that is not here; test_sweep_replay replays others',
    r'^\./ws check (?!heading rotate_robot)': 'is of a node that is not here',
    r' https://github.com/|^mkdir -p \.ws/|^echo |^export |^\./ws true$': 'needs the network, and compiles for minutes',
    r'^\./ws (dask|sweep .*--cluster) ': 'needs more machines; test_sweep_cluster makes a cluster',
}
IS_CLONE = (ROOT / '.git').exists() and shutil.which('git')
if not IS_CLONE:
    NOT_HERE['^git clone '] = 'this is no clone'
if not (ROOT / '.ws' / 'devel' / 'lib' / 'move_base').exists():
    NOT_HERE[r'map\.launch|navigate\.launch|move_base|map_server|tf_echo map'] = 'docs/navigation.md builds them'
NEEDS_SCREEN = re.compile(r'--gui|gui:=|rviz:=')
READERS = 4


def sessions():
    """Return the commands that are typed one after the other, by the heading at which they begin."""
    commands = [command for path in DOCUMENTS
                for command in read_commands(str(path.relative_to(ROOT)), path.read_text())]
    found = {}
    for number, command in enumerate(commands):
        if command.inline and not command.shown and is_mentioned_again(command, number, commands):
            continue
        key = GOES_ON.get(command.text, GOES_ON.get(
            command.heading, f'{command.document}: {command.heading}'))
        found.setdefault(key, []).append(command)
    return found


def is_mentioned_again(command, number, commands):
    """Return whether the same command is typed earlier, or anywhere with more arguments."""
    words = set(command.text.split())
    return any(words < set(other.text.split()) for other in commands) or any(
        command.text == other.text for other in commands[:number])


SESSIONS = sessions()


@pytest.fixture(scope='module')
def readers(request, tmp_path_factory):
    """Have several readers at work, side by side; return what has become of each session."""
    keys = [item.callspec.params['key'] for item in request.session.items
            if hasattr(item, 'callspec') and 'key' in item.callspec.params]
    with ExitStack() as stack:
        if shutil.which('Xvfb'):
            stack.enter_context(virtual_screen())
        pool = stack.enter_context(ThreadPoolExecutor(READERS))
        yield {key: pool.submit(read, key, tmp_path_factory.mktemp('home')) for key in keys}


def read(key, home):
    commands = SESSIONS[key]
    text = '\n'.join(command.text for command in commands)
    if NEEDS_SCREEN.search(text) and 'DISPLAY' not in os.environ:
        return 'Xvfb is not installed'
    if key == WORKSPACE and not IS_CLONE:
        return 'this is no clone'
    make_home(home)
    in_shell = commands[0].heading not in OUTSIDE_THE_SHELL
    with hold_port() as port, hold_port() as page_port, \
            Reader(home, environment(port, page_port), in_shell) as reader:
        for before in BEFORE.get(commands[0].heading, []):
            reader.follow(typed(before))
        for command in commands:
            try:
                follow(reader, command)
            except AssertionError as error:
                raise AssertionError(f'{command}\n{error}') from None
    return None


def follow(reader, command):
    if any(re.search(pattern, command.text) for pattern in NOT_HERE):
        return
    text = typed(command.text)
    reader.follow(text, [] if '--help' in text else command.shown)


def typed(text):
    for pattern, replacement, _ in IN_PLACE:
        text = re.sub(pattern, replacement, text)
    for word, value in PLACEHOLDERS.items():
        text = re.sub(rf'(?<!\w){word}(?!\w)', lambda _, value=value: value, text)
    return text


def make_home(home):
    with rosbag.Bag(str(home / 'run.bag'), 'w') as bag:
        for step in range(50):
            bag.write('/odom', odometry(x=0.01 * step, stamp=100 + 0.1 * step),
                      rospy.Time.from_sec(100 + 0.1 * step))


def environment(port, page_port):
    return {'PATH': '/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin',
            'TERM': 'xterm', 'LANG': 'C.UTF-8', 'DISPLAY': os.environ.get('DISPLAY', ''),
            'LIBGL_ALWAYS_SOFTWARE': '1', 'ROS_MASTER_URI': f'http://localhost:{port}',
            'PAGE_PORT': str(page_port), 'ODOMETRY_RUNS': os.environ['ODOMETRY_RUNS']}


@pytest.mark.parametrize('key', [
    pytest.param(key, marks=[] if key.startswith('README.md: ') else pytest.mark.nightly) for key in SESSIONS])
def test_what_is_typed_does_what_is_shown(key, readers):
    if error := readers[key].exception():
        pytest.fail(f'{error}', pytrace=False)
    if reason := readers[key].result():
        pytest.skip(reason)

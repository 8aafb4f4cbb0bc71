"""How ./ws builds the user's packages, and what it says of those that it cannot build."""

import contextlib
import fcntl
import os
import re
import shutil

import pytest
from checkout import (
    CMAKE,
    FASTER,
    RUN_MINE,
    START,
    TIMEOUT,
    command_in,
    in_checkout,
    make_package,
    set_up,
)
from odometry_tests.processes import Process
from odometry_tests.terminal import Terminal

# A package, the file in it that is wrong, how, and what is said of that.
BAD = [
    ('test_movement', 'package.xml', '1.0.0', '1.0.1', 'has the name test_movement, too: rename yours'),
    ('nobodys', 'package.xml', '<maintainer email="me@example.com">Me</maintainer>', '', 'at least one maintainer'),
    ('open', 'package.xml', '</package>', '', 'invalid XML'),
    ('unconfigured', 'CMakeLists.txt', 'REQUIRED)', 'REQUIRED COMPONENTS nowhere)',
     'Could not find a package configuration file provided by "nowhere"'),
    ('waiting', 'package.xml', '</package>', '<depend>unconfigured</depend></package>', 'it depends on unconfigured'),
    ('conditional', 'package.xml', '<buildtool_depend>', '<buildtool_depend condition="$ROS_VERSION = 1">', 'failed to parse'),
    ('uncompiled', 'CMakeLists.txt', 'catkin_package()', 'catkin_package()\nadd_library(x x.cpp)', 'x.cpp:1:.* error: '),
]
# apt knows these; none is installed, and none can be.
DEPENDS = """
apt-cache() { printf '%s\\n' libapache2-mod-php tf libtf-dev tf-tools python3-tf2-ros libtf2-ros-dev; }
has_parts() { [ "$1" = catkin ]; }  # the first of what every command needs
need_parts() { has_parts "$@" || fail "this needs $*"; }
"""


def replace(file, old, new):
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))


@contextlib.contextmanager
def another_set_up(folder):
    with open(folder / '.ws/lock', 'w') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@pytest.mark.nightly
def test_a_workspace_is_built_when_something_has_changed(checkout, tmp_path):
    """Packages of the user stay, and nothing comes in from another workspace that is sourced."""
    (tmp_path / 'other').mkdir()
    (tmp_path / 'other/.catkin').write_text('/nowhere')
    (tmp_path / 'other/catkin_pkg.py').write_text('raise ImportError("of another workspace")')
    other = {name: f'{tmp_path}/other' for name in
             ('CMAKE_PREFIX_PATH', 'PYTHONPATH', 'ROS_PACKAGE_PATH')}
    run = in_checkout(checkout, RUN_MINE, **other)
    assert run.stdout.startswith('hello from pybullet\n'), run.output
    assert f'{tmp_path}/other' not in run.stdout
    with another_set_up(checkout):  # it need not wait: nothing is missing
        assert set_up(checkout).output.strip() == ''
    replace(checkout / 'test_movement/package.xml', '1.0.0', '1.0.1')
    with another_set_up(checkout):
        run = Process(*command_in(checkout, RUN_MINE))
        run.wait_for_output('./ws: another set-up is running; waiting for it')
        assert run.running and 'building' not in run.output
    assert run.wait(60.0) == 0, run.output
    assert 'building the packages' in run.stderr and 'hello from pybullet' in run.stdout


def test_a_bad_package_is_named_and_stops_no_other(checkout):
    """In later calls too, which build nothing; once it is mended, it alone is built."""
    student = checkout / '.ws/src/student'
    for name, file, old, new, _ in BAD:
        make_package(student / name, 'pybullet')
        replace(student / name / file, old, new)
    (student / 'uncompiled/x.cpp').write_text('int x() { return 1 }')
    (student / 'uncompiled/.#x.cpp').symlink_to('me@laptop')  # Emacs's lock
    replace(student / 'waiting/CMakeLists.txt', 'REQUIRED)', 'REQUIRED COMPONENTS unconfigured)')
    make_package(student / 'latin', 'pybullet').rename(student / os.fsdecode(b'latin \xe9'))
    copied = make_package(student / 'copied', 'pybullet')
    shutil.copytree(checkout / 'test_movement/src', copied / 'src')
    shutil.copy(checkout / 'test_movement/setup.py', copied)
    replace(copied / 'CMakeLists.txt', 'catkin_package()', 'catkin_python_setup()\ncatkin_package()')
    reasons = {**{name: reason for name, *_, reason in BAD}, 'copied': 'module straight_drive is one of ours',
               'latin': 'its path is not UTF-8'}
    for building in (['./ws: building the packages ...'], []):
        run = in_checkout(checkout, RUN_MINE)
        assert run.stdout.startswith('hello from pybullet\n'), run.output
        shown = run.stderr.splitlines()
        assert shown[:len(building)] == building
        assert run.stderr.count('./ws: ') == len(building) + len(reasons), run.stderr
        for name, reason in reasons.items():
            assert any(re.search(rf'\b{name}\b.*: .*{reason}', line) for line in shown), (name, run.stderr)
    assert not (checkout / '.ws/devel/lib/python3/dist-packages/straight_drive/__init__.py').is_symlink()
    made = (checkout / '.ws/build/src+mine/CMakeCache.txt').stat()
    (student / 'uncompiled/x.cpp').write_text('int x() { return 1; }')
    run = in_checkout(checkout, RUN_MINE)
    assert 'building the packages' in run.stderr and 'uncompiled' not in run.stderr, run.stderr
    assert (checkout / '.ws/build/src+mine/CMakeCache.txt').stat() == made


def depend(checkout, *names):
    """Have the package of the user's depend on others."""
    depends = ''.join(f'<depend>{name}</depend>' for name in names)
    replace(checkout / '.ws/src/mine/package.xml', '</package>', f'{depends}</package>')


def test_what_a_package_depends_on_is_installed(checkout):
    """As far as rosdep's table has it; other names are only said, and without root the others run."""
    depend(checkout, 'tf', 'tf2_ros', 'odometry_common', 'nowhere', 'libapache2-mod-php')
    run = in_checkout(checkout, DEPENDS + RUN_MINE)
    assert 'hello from pybullet' in run.stdout, run.output
    assert run.stderr.splitlines()[:4] == [
        ("./ws: mine depends on libapache2-mod-php, which is Debian's, not ROS's: "
         'sudo apt-get install --no-remove libapache2-mod-php'),
        "./ws: mine depends on nowhere, which apt does not know",
        './ws: this needs libtf-dev tf-tools libtf2-ros-dev python3-tf2-ros',
        './ws: continuing without these dependencies of packages in .ws/src'], run.stderr


def test_on_a_terminal_it_asks_before_it_installs_what_a_package_depends_on(checkout):
    depend(checkout, 'tf')
    script = checkout / 'set_up.bash'
    script.write_text(f'{START}{DEPENDS}{FASTER}set_up true')
    with Terminal(checkout, {**os.environ, 'CHECKOUT': str(checkout)}) as terminal:
        terminal.type('bash set_up.bash')
        terminal.wait_for_output('    tf-tools')
        terminal.wait_for_output('install them? [Y/n]')
        terminal.type('n')
        assert terminal.wait_for_prompt(TIMEOUT) == 0, terminal.output
    assert 'this needs' not in terminal.output and 'to be asked again: rm ' in terminal.output


def test_apt_may_remove_nothing(checkout):
    run = in_checkout(checkout, 'as_root() { "$@"; }\napt_get -s install libboost1.81-dev || apt_get -s install libmpich-dev', status=None)
    assert 'Remv' not in run.stdout, run.output


def test_a_build_is_tried_again_once_something_was_installed(checkout):
    (checkout / '.ws/src/mine/CMakeLists.txt').write_text('message(FATAL_ERROR "no SDL")')
    assert 'building' in set_up(checkout).stderr
    installed = 'DPKG=$CHECKOUT/status\n'
    assert 'building' not in set_up(checkout, installed).stderr
    assert 'building' in set_up(checkout, installed + 'touch "$DPKG"\n').stderr


def make_program(folder, text, age=0.0):
    """Make a package with a program that prints the text; its files are older by age, in seconds."""
    make_package(folder, 'pybullet')
    (folder / 'CMakeLists.txt').write_text(
        CMAKE.format(name=folder.name) + 'add_executable(${PROJECT_NAME}_node x.cpp)\n')
    (folder / 'x.cpp').write_text(f'#include <cstdio>\nint main() {{ puts("{text}"); }}')
    for path in folder.iterdir():
        os.utime(path, (path.stat().st_mtime - age,) * 2)


@pytest.mark.parametrize('leave_out', [shutil.rmtree, lambda folder: (folder / 'CATKIN_IGNORE').touch()],
                         ids=['removed', 'ignored'])
def test_a_package_that_takes_the_place_of_another_is_built_from_nothing(checkout, leave_out):
    """Also if its files are older; the program of a package that is removed or ignored does not run."""
    run_it = FASTER + 'set_up true\nset +u\n. "$WORKSPACE/devel/setup.bash"\nrosrun hw hw_node'
    folder = checkout / '.ws/src/hw'
    for text, age in ('first', 0.0), ('second', 1e5):
        shutil.rmtree(folder, ignore_errors=True)
        make_program(folder, text, age)
        assert in_checkout(checkout, run_it).stdout == text
    leave_out(folder)
    run = in_checkout(checkout, run_it, status=None)
    assert run.wait() != 0 and 'hw' in run.stderr, run.output
    assert not (checkout / '.ws/devel/lib/hw/hw_node').is_symlink()


def test_a_package_of_ours_that_has_gone_leaves_no_program(checkout):
    """As after an update, which may move it."""
    program = checkout / '.ws/devel/lib/test_movement/test_movement.py'
    set_up(checkout)
    assert program.exists()
    set_up(checkout, 'PACKAGES=(odometry_common)\nrm "$CHECKOUT/.ws/ready"\n')
    assert not program.exists()

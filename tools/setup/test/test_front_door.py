"""What ./ws answers before anything is set up, and where it cannot go on."""

import re
import shutil

import pytest
from checkout import in_checkout, make_checkout
from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

DEBIAN = """
OPT=/nowhere
has_parts() { [[ $1 == *python3-rospy* ]]; }
run_step() { "${@:2}"; }
as_root() { true; }
"""
NO_SUDO = DEBIAN + """
id() { echo 1000; }
sudo() { return 1; }
set_up roslaunch odometry_launch sim.launch rviz:=true
"""
PACKAGES = DEBIAN + """
dpkg() { [ "$1" != --audit ] && command dpkg "$@"; }
apt-cache() { printf 'python3-rospy:\\n  Installed: (none)\\n  Candidate: %s\\n' "$CANDIDATE"; }
sudo() { true; }
apt_get() { [ "$1" != install ] || echo installs; }
add_requirements() { exit 0; }
set_up demo
"""
EXTRAS = """
PARTS=() REQUIREMENTS=()
add_extras "${WORDS[@]}"
echo "${PARTS[*]} ${REQUIREMENTS[*]}"
"""
VIEW, TESTS = (f'{folder}/requirements.txt' for folder in ('tools/robot_view', 'test'))
CLUSTER = 'tools/odometry_tools/requirements-cluster.txt'


@pytest.fixture
def fresh(tmp_path):
    return make_checkout(tmp_path / 'fresh/robot', made=())


@pytest.mark.parametrize('arguments, answer', [
    ('--host 192.0.2.1 --view', '--view is not one of --host ADDRESS, --set-up, --help'),
    ('--host 192.0.2.1 --host', '--host needs an address of this machine that others can reach'),
    ('--help', '')])
def test_help_and_one_line_for_what_makes_no_sense_make_nothing(fresh, arguments, answer):
    before = set(fresh.iterdir())
    ended = in_checkout(fresh, f'"$CHECKOUT/ws" {arguments}', status=2 if answer else 0)
    assert ended.stderr == (answer and f'./ws: {answer}') and set(fresh.iterdir()) == before
    assert ended.stdout.startswith('' if answer else 'usage: ./ws')


@pytest.mark.parametrize('command, hint', [
    ('foo', ''), ('--set-up foo', ''), ('rqt_plot', ': Debian has no rqt. ./ws rosrun robot_view view.py draws plots, too')])
def test_a_command_that_is_not_there(command, hint):
    ended = run(ROOT / 'ws', *command.split(), status=2)
    assert ended.output.strip() == f'./ws: there is no command {command.split()[-1]}{hint}'


@pytest.mark.parametrize('variable, status, answer', [
    ('PYTHONHOME', 0, ''), ('PYTHONPATH', 1, "with PYTHONPATH={} .*/setup.bash fails: .*'platform' has no .*")])
def test_a_variable_that_stops_python_is_named_or_of_no_effect(tmp_path, variable, status, answer):
    """As a folder with a module of the name of one of Python's own."""
    (tmp_path / 'platform.py').write_text('x = 1\n')
    ended = run('env', f'{variable}={tmp_path}', ROOT / 'ws', 'true', status=status)
    assert re.fullmatch(answer.format(tmp_path), ended.output.strip().replace('./ws: ', '', 1)), ended.output


@pytest.mark.parametrize('command, extras', [
    ('grep -c pytest docs/ci.md', ''), ('rospack find rviz', ''),
    ('echo --gui', ''), ('rosrun robot_view view.py', VIEW), ('demo --view', VIEW),
    ('roslaunch odometry_launch sim.launch view:=true', VIEW), ('roslaunch odometry_launch sim.launch gui:=false', ''),
    ('rviz', 'rviz'), ('demo --gui --view', f'libgl1 libx11-6 {VIEW}'), ('rosrun tf tf_echo odom base_link', 'libtf-dev tf-tools'),
    ('pre-commit run', f'catkin-lint {TESTS}'), ('sweep move', ''),
    ('dask worker', CLUSTER), ('sweep move --cluster tcp://a:1', CLUSTER),
    ('check heading my.py --view', VIEW)])
def test_a_word_installs_something_only_where_it_means_that(fresh, command, extras):
    added = in_checkout(fresh, f'WORDS=({command})\n{EXTRAS}')
    assert added.stdout.split() == extras.split(), added.output


@pytest.mark.parametrize('command', ['test --help', 'pytest', 'python3 -m pytest -x'])
def test_tests_need_everything_that_they_test(fresh, command):
    """In a fresh clone too, where the first call may ask for help."""
    words = in_checkout(fresh, f'WORDS=({command})\n{EXTRAS}').stdout.split()
    assert {TESTS, VIEW, CLUSTER, 'rviz', 'chromium', 'libgl1'} <= set(words)


def last_words(folder, commands, **variables):
    """Return the one line with which a set-up ends, without its beginning."""
    ended = in_checkout(folder, commands, status=1, **variables)
    assert ended.stdout == '' and len(ended.stderr.splitlines()) == 1, ended.output
    return ended.stderr.replace('./ws: ', '', 1)


def test_another_kind_of_system(tmp_path):
    (tmp_path / 'bash').symlink_to(shutil.which('bash'))
    (tmp_path / 'uname').write_text('#!/bin/sh\necho Darwin\n')
    (tmp_path / 'uname').chmod(0o755)
    ended = run('/usr/bin/env', '-i', f'PATH={tmp_path}', ROOT / 'ws', 'demo', status=1)
    assert ended.output.strip() == './ws: this needs Linux. On Darwin, use the container: docs/container.md'


def test_packages_of_the_system(fresh):
    assert 'installs' in in_checkout(fresh, PACKAGES, CANDIDATE='1.16.0+ds-2').stdout
    assert last_words(fresh, PACKAGES, CANDIDATE='1.15.9+ds1-7+deb11u1') == (
        'the packages of this system contain no ROS 1, or one that is too old. Use the container: '
        'docs/container.md')


def test_no_sudo(fresh):
    start, parts = last_words(fresh, NO_SUDO).split(' --no-install-recommends ')
    assert start == 'this needs an administrator to run: sudo apt-get install'
    assert {'catkin', 'python3-venv', 'rviz'} <= set(parts.split())

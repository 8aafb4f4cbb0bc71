"""Where ./ws cannot go on, one line says why and what can be done."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest
from odometry_tests.checkout import in_checkout, make_checkout
from odometry_tests.scripts import ROOT

DEBIAN = """
OPT=/nowhere
has_parts() { [[ $1 == *python3-rospy* ]]; }
run_step() { "${@:2}"; }
as_root() { true; }
has_pybullet_wheel() { true; }
"""
NO_SUDO = DEBIAN + """
id() { echo 1000; }
sudo() { return 1; }
has_pybullet_wheel() { false; }
is_kept() { false; }
set_up demo --view rviz:=true
"""
OLD_PACKAGES = DEBIAN + """
dpkg() { [ "$1" != --audit ] && command dpkg "$@"; }
apt-cache() { printf 'python3-rospy:\\n  Installed: (none)\\n  Candidate: %s\\n' "$CANDIDATE"; }
sudo() { true; }
apt_install() { echo installs; }
need_base_python() { exit; }
set_up demo
"""
SMALL_DISK = DEBIAN + """
df() { printf 'of no interest\\n/dev/disk 9999 9900 99 100%% /\\n'; }
set_up demo
"""
LACKING = """
OPT=$CHECKOUT/opt
mkdir -p "$OPT/noetic" "$CHECKOUT/usr/bin"
touch "$OPT/noetic/setup.bash"
USR=$CHECKOUT/usr
cat >"$USR/bin/python3" <<'END'
#!/bin/sh
case "$*" in
    *find_spec*' tf '*) echo nav_msgs; echo tf ;;
    *ensurepip*) exit 1 ;;
esac
END
chmod +x "$USR/bin/python3"
type() { true; }
has_pybullet_wheel() { true; }
set_up demo
"""


@pytest.fixture
def fresh(tmp_path):
    """Make a checkout in which nothing is set up."""
    return make_checkout(tmp_path / 'fresh' / 'robot', made=())


def last_words(folder, commands, **variables):
    """Return the one line with which a set-up ends, without its beginning."""
    run = in_checkout(folder, commands, **variables)
    assert run.wait() == 1, run.output
    assert run.stdout == '' and len(run.stderr.splitlines()) == 1, run.output
    return run.stderr.strip().replace('./ws: ', '', 1)


def test_another_kind_of_system(tmp_path):
    """On macOS there is an older bash and another readlink: nothing else is called there."""
    (tmp_path / 'bash').symlink_to(shutil.which('bash'))
    (tmp_path / 'uname').write_text('#!/bin/sh\necho Darwin\n')
    (tmp_path / 'uname').chmod(0o755)
    run = subprocess.run(['/usr/bin/env', '-i', f'PATH={tmp_path}', ROOT / 'ws', 'demo'],
                         check=False, capture_output=True, text=True)
    assert (run.returncode, run.stdout) == (1, '')
    assert run.stderr == './ws: this needs Linux. On Darwin the container runs: docs/container.md\n'


@pytest.mark.parametrize('candidate', ['(none)', '1.15.9+ds1-7+deb11u1'])
def test_a_system_without_ros(fresh, candidate):
    """Debian 11 has one that fails on its own Python."""
    words = last_words(fresh, OLD_PACKAGES, CANDIDATE=candidate)
    assert words == ('ROS 1 is not among the packages of this system, or too old. Here, as '
                     'anywhere, the container runs: docs/container.md')


def test_new_packages_are_installed(fresh):
    """Of Debian 12."""
    assert 'installs' in in_checkout(fresh, OLD_PACKAGES, CANDIDATE='1.16.0+ds-2').stdout


def test_no_sudo(fresh):
    """An administrator needs one command only, with what the typed command asks for besides."""
    words = last_words(fresh, NO_SUDO)
    start, parts = words.split(' --no-install-recommends ')
    assert start == 'this needs root or sudo, or somebody who has it and types: sudo apt-get install'
    assert {'catkin', 'python3-venv', 'rviz', 'python3-dev'} <= set(parts.split())
    assert 'python3-rospy' not in parts


def test_a_small_disk(fresh):
    """Nothing has been downloaded yet."""
    assert last_words(fresh, SMALL_DISK).endswith('where 99 MB are free')
    assert not (fresh / '.ws').exists()


def test_a_ros_that_lacks_something(fresh):
    """It is not ours to change."""
    assert last_words(fresh, LACKING) == (
        f'the ROS in {fresh}/opt/noetic lacks nav_msgs tf python3-venv: sudo apt-get install '
        '--no-install-recommends ros-noetic-nav-msgs ros-noetic-tf python3-venv')


@pytest.fixture
def of_another():
    """Make a checkout that this test's user may read, but not write to."""
    folder = Path(tempfile.mkdtemp(dir='/var/tmp'))
    shutil.copytree(ROOT / 'launch' / 'scripts', folder / 'launch' / 'scripts')
    shutil.copy(ROOT / 'ws', folder)
    folder.chmod(0o555)
    yield folder
    folder.chmod(0o755)
    shutil.rmtree(folder)


def test_a_checkout_of_another_user(of_another):
    """Without `permission denied`."""
    nobody = ['setpriv', '--reuid', '65534', '--clear-groups'] if os.getuid() == 0 else []
    run = subprocess.run([*nobody, of_another / 'ws', 'demo'], check=False, capture_output=True,
                         text=True, env={'PATH': os.environ['PATH'], 'HOME': '/nowhere'})
    assert run.returncode == 1
    assert run.stderr == (f'./ws: you cannot write to {of_another}, which belongs to '
                          f'{of_another.owner()}: clone the project into a folder of your own\n')

# Which ROS 1 ./ws uses: Debian's packages, which it installs, or an existing one, which it leaves
# unchanged.
USR=/usr
OPT=/opt/ros

# find_ros: set ROS, the folder that has it, and its PYTHON. A workspace stays with the ROS it was
# made with, whatever a terminal has sourced.
find_ros() {
    ! remembers_ros || return 0
    if [ "${ROS_VERSION:-}" = 1 ] && read -r ROS < <(type -P catkin_make); then
        ROS=${ROS%/bin/catkin_make}
        ROS=${ROS:-$USR}
    elif [ -f "$OPT/noetic/setup.bash" ]; then
        ROS=$OPT/noetic
    elif [ -f "$OPT/one/setup.bash" ]; then
        ROS=$OPT/one
    elif type -P dpkg-query >/dev/null; then
        ROS=$USR
    else
        nowhere 'this system has no ROS 1'
    fi
    PYTHON=$ROS/bin/python3  # conda has one
    [ -x "$PYTHON" ] || PYTHON=$USR/bin/python3
}

remembers_ros() { { read -r ROS && read -r PYTHON; } 2>/dev/null <"$VENV/ros"; }
is_debians() { [ "$ROS" = "$USR" ]; }

# load_ros: source it. conda's has no file for that: a terminal has to activate it.
load_ros() {
    if [ -f "$ROS/setup.bash" ]; then
        set +u
        . "$ROS/setup.bash"
        set -u
    elif ! is_debians && [ "$(type -P catkin_make)" != "$ROS/bin/catkin_make" ]; then
        fail "this workspace was made with the ROS in $ROS: activate that, or delete .venv and .ws"
    fi
}

# check_ros: end with one line if an existing ROS lacks something.
check_ros() {
    local lacks program
    is_debians && return
    lacks=$(
        load_ros && "$PYTHON" -c "$MISSING_MODULES" ensurepip \
            $(grep -o 'python3-\S*' <<<"${DEBIAN_PARTS[*]}")
        for program in catkin_make "${CXX:-c++}" make; do
            type -P "$program" >/dev/null || echo "$program"
        done
    )
    [ -z "$lacks" ] || fail "the ROS in $ROS lacks ${lacks//$'\n'/, }: install that where this ROS came \
from (Debian and Ubuntu: as ros-${ROS##*/}-NAME, python3-venv, g++, make)"
}

MISSING_MODULES='
import importlib.util, re, sys
for part in sys.argv[1:]:
    name = re.sub("^python3-", "", part).replace("-", "_")
    if not importlib.util.find_spec(name):
        print(name)'

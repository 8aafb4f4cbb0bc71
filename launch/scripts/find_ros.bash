# Which ROS 1 ./ws uses: Debian's packages, which it installs, or one that is there already, which it
# leaves as it is.
OPT=/opt/ros
SYSTEM_PYTHON=/usr/bin/python3

# find_ros: name the folder ROS that it is in, which is /usr for Debian's packages, and its PYTHON.
# What was made with one is not made anew because a terminal has sourced another.
find_ros() {
    remembers_ros && return
    is_sourced || is_in_opt || is_in_packages || nowhere 'this system has no ROS 1'
    PYTHON=$ROS/bin/python3
    # Only conda's has a Python of its own.
    [ "$ROS" != /usr ] && "$PYTHON" -c 'import rospy' 2>/dev/null || PYTHON=$SYSTEM_PYTHON
}

remembers_ros() {
    { read -r ROS && read -r PYTHON; } 2>/dev/null <"$VENV/ros" &&
        [ -x "$ROS/bin/catkin_make" ] && [ -x "$PYTHON" ]
}

# is_sourced: as in an environment of conda, or after the setup.bash of one built from source.
is_sourced() {
    [ "${ROS_VERSION:-}" = 1 ] || return
    read -r ROS < <(type -P catkin_make) || return
    ROS=${ROS%/bin/catkin_make}
    # In Debian's a workspace may be sourced, such as this one in ./ws shell.
    [[ $ROS == /* && $ROS != /usr && $ROS != /usr/local ]]
}

is_in_opt() {
    for ROS in "$OPT/noetic" "$OPT/one"; do
        [ ! -f "$ROS/setup.bash" ] || return 0
    done
    return 1
}

is_in_packages() {
    ROS=/usr
    type -P dpkg-query >/dev/null
}

# stands_on_what_is_sourced: whether a ROS has no file that could be sourced anew. What ./ws makes
# stands on no other workspace.
stands_on_what_is_sourced() {
    [ "$ROS" != /usr ] && [ ! -f "$ROS/setup.bash" ]
}

load_ros() {
    ! stands_on_what_is_sourced || is_sourced ||
        fail "this workspace was made with the ROS in $ROS: source its setup file first"
    if [ -f "$ROS/setup.bash" ]; then
        set +u
        . "$ROS/setup.bash"
        set -u
    fi
}

# check_ros: end with one line if something is missing in a ROS that is not ours to change.
check_ros() {
    [ "$ROS" != /usr ] || return 0
    local lacks
    lacks=$(load_ros; what_ros_lacks)
    [ -z "$lacks" ] || fail "the ROS in $ROS lacks ${lacks//$'\n'/ }: $(how_to_add "$lacks")"
}

what_ros_lacks() {
    local part
    type -P catkin_make >/dev/null || echo catkin
    type -P rosrun >/dev/null || echo rosbash
    for part in "${DEBIAN_PARTS[@]}"; do
        [[ $part != python3-* ]] || tr - _ <<<"${part#python3-}"
    done | xargs "$PYTHON" -c "$MISSING_MODULES"
    "$PYTHON" -c 'import ensurepip, venv' 2>/dev/null || echo python3-venv
    type -P "${CXX:-c++}" >/dev/null || echo g++
    type -P make >/dev/null || echo make
    has_pybullet_wheel || is_kept || "$PYTHON" -c "$HAS_HEADERS" || echo python3-dev
}
MISSING_MODULES='
import importlib.util, sys
for name in sys.argv[1:]:
    if not importlib.util.find_spec(name): print(name)'
HAS_HEADERS='
import os, sys, sysconfig
sys.exit(not os.path.exists(sysconfig.get_path("include") + "/Python.h"))'

# how_to_add PARTS: the command that installs what a ROS lacks.
how_to_add() {
    local part names=()
    for part in $1; do
        case $part in
            g++ | make | python3-*) names+=("$part") ;;
            *) names+=("ros-${ROS##*/}-${part//_/-}") ;;
        esac
    done
    case $ROS in
        "$OPT"/*) echo "sudo apt-get install ${names[*]}" ;;
        *) echo 'add it where this ROS came from' ;;
    esac
}

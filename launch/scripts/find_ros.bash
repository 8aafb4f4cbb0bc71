# Which ROS 1 ./ws uses: Debian's packages, which it installs, or one that is there already, which
# it leaves as it is.
USR=/usr
OPT=/opt/ros
ROS=$USR
PYTHON=$USR/bin/python3

# find_ros: name the folder ROS that it is in, and its PYTHON.
# What was made with one is not made anew because a terminal has sourced another.
find_ros() {
    ! remembers_ros || return 0
    is_sourced || is_in_opt || may_be_in_packages || nowhere 'this system has no ROS 1'
    # Only conda's has a Python of its own.
    PYTHON=$ROS/bin/python3
    ! is_debians && "$PYTHON" -c 'import rospy' 2>/dev/null || PYTHON=$USR/bin/python3
}

remembers_ros() {
    { read -r ROS && read -r PYTHON; } 2>/dev/null <"$VENV/ros" &&
        [ -x "$ROS/bin/catkin_make" ] && [ -x "$PYTHON" ]
}

# is_sourced: as in an environment of conda, or after the setup.bash of one built from source.
is_sourced() {
    [ "${ROS_VERSION:-}" = 1 ] && read -r ROS < <(type -P catkin_make) || return
    ROS=${ROS%/bin/catkin_make}
    # On Debian's packages a workspace may be sourced, such as this one in ./ws shell.
    [ -n "$ROS" ] && ! is_debians
}

is_in_opt() {
    for ROS in "$OPT/noetic" "$OPT/one"; do
        [ ! -f "$ROS/setup.bash" ] || return 0
    done
    return 1
}

may_be_in_packages() {
    ROS=$USR
    type -P dpkg-query >/dev/null
}

is_debians() {
    [ "$ROS" = "$USR" ]
}

# has_no_file: whether a ROS has none that could be sourced anew, so that it has to be sourced.
has_no_file() {
    ! is_debians && [ ! -f "$ROS/setup.bash" ]
}

load_ros() {
    ! has_no_file || is_sourced ||
        fail "this workspace was made with the ROS in $ROS: source its setup file first"
    [ -f "$ROS/setup.bash" ] || return 0
    set +u
    . "$ROS/setup.bash"
    set -u
}

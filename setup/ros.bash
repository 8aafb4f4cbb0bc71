# Which ROS 1 ./ws uses: Debian's packages, which it installs, or an existing one, which it leaves
# unchanged.
USR=/usr
OPT=/opt/ros

# find_ros: set ROS, its folder, and PYTHON. A workspace keeps the ROS with which it was made, whatever
# a terminal has sourced.
find_ros() {
    [ -f "$VENV/ros" ] && { read -r ROS && read -r PYTHON; } <"$VENV/ros" && return
    if [ "${ROS_VERSION:-}" = 1 ] && ROS=$(type -P catkin_make); then
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
    PYTHON=$USR/bin/python3
}

is_debians() { [ "$ROS" = "$USR" ]; }

# load_ros: source it, and nothing else.
load_ros() {
    unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH PYTHONPATH PYTHONHOME PKG_CONFIG_PATH LD_LIBRARY_PATH \
        AMENT_PREFIX_PATH ROS_VERSION ROS_DISTRO
    set +u
    is_debians || . "$ROS/setup.bash"
    set -u
    export PATH=$VENV/bin:$PATH
}

# Enter the workspace in ODOMETRY_ROOT, as ./ws and its shell do before a command. Source this from a
# function without arguments: catkin reads the arguments of its caller.
# ROS 2 has modules and variables of the same names.
[ "${ROS_VERSION:-}" != 2 ] ||
    unset PYTHONPATH LD_LIBRARY_PATH CMAKE_PREFIX_PATH AMENT_PREFIX_PATH ROS_VERSION ROS_DISTRO
# It writes a file, and prints a traceback if that fails.
. "$ODOMETRY_ROOT/.ws/devel/setup.bash" &>/dev/null || {
    echo "./ws: nothing can be written to ${TMPDIR:-/tmp}: full disk, or limited files (ulimit -f)" >&2
    exit 1
}
export PATH=$ODOMETRY_ROOT/setup/bin:$ODOMETRY_ROOT/.venv/bin:$PATH

address=${ROS_HOSTNAME:-${ROS_IP:-localhost}}
case ${address,,} in
    localhost | localhost.* | *.localhost | localhost[46] | ip6-localhost | ip6-loopback | 127.* | ::1)
        # rospy listens on loopback only if ROS_HOSTNAME is localhost. The C++ rosout never does: use
        # the one in our roscore.xml.
        export ROS_HOSTNAME=localhost ROS_ETC_DIR=$ODOMETRY_ROOT/launch/etc
        unset ROS_IP ;;
esac
unset address

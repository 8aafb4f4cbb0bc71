# What ./ws and its shell do before a command: they enter the workspace in ODOMETRY_ROOT. catkin
# looks at arguments, so that a function without any has to source this.
# ROS 2 has modules and variables of the same names.
[ "${ROS_VERSION:-}" != 2 ] ||
    unset PYTHONPATH LD_LIBRARY_PATH CMAKE_PREFIX_PATH AMENT_PREFIX_PATH ROS_VERSION ROS_DISTRO
# It writes a file, and would show how that fails in a traceback.
. "$ODOMETRY_ROOT/.ws/devel/setup.bash" &>/dev/null || {
    echo "./ws: nothing can be written to ${TMPDIR:-/tmp}: full disk, or limited files (ulimit -f)" >&2
    exit 1
}
export PATH=$ODOMETRY_ROOT/setup/bin:$ODOMETRY_ROOT/.venv/bin:$PATH

address=${ROS_HOSTNAME:-${ROS_IP:-localhost}}
case ${address,,} in
    localhost | localhost.* | *.localhost | localhost[46] | ip6-localhost | ip6-loopback | 127.* | ::1)
        # Of loopback's names rospy knows this one only; under another, and without any, it listens to
        # the whole network. The C++ rosout, which catkin's files have just named, always does.
        export ROS_HOSTNAME=localhost ROS_ETC_DIR=$ODOMETRY_ROOT/launch/etc
        unset ROS_IP ;;
esac
unset address

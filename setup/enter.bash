# Enter the workspace in ODOMETRY_ROOT; ./ws and its shell do so before a command. Source this from a
# function without arguments: catkin reads the arguments of its caller.
unset PYTHONHOME  # the workspace's Python has its own
# ROS 2 uses the same names for modules and variables.
[ "${ROS_VERSION:-}" != 2 ] ||
    unset PYTHONPATH LD_LIBRARY_PATH CMAKE_PREFIX_PATH AMENT_PREFIX_PATH ROS_VERSION ROS_DISTRO
setup=$ODOMETRY_ROOT/.ws/devel/setup.bash
. "$setup" &>/dev/null || {
    # Once more for its message, and without PYTHONPATH to see whether that is the cause.
    reason=$(. "$setup" 2>&1 >/dev/null | tail -n 1) || true
    ! (unset PYTHONPATH && . "$setup" &>/dev/null) || setup="with PYTHONPATH=$PYTHONPATH $setup"
    echo "./ws: $setup fails: $reason" >&2
    exit 1
}
export PATH=$ODOMETRY_ROOT/.venv/bin:$PATH
# Where a processor has FMA, glibc's sin, cos and atan2 use it, and differ in the last bit: the same motion
# on each x86-64.
[ "$HOSTTYPE" != x86_64 ] || export GLIBC_TUNABLES=${GLIBC_TUNABLES-glibc.cpu.hwcaps=-FMA,-FMA4}

variable=ROS_IP
[ -z "${ROS_HOSTNAME:-}" ] || variable=ROS_HOSTNAME
address=${!variable:-localhost}
case ${address,,} in
    localhost | localhost.* | *.localhost | localhost[46] | ip6-localhost | ip6-loopback | 127.* | ::1)
        # rospy listens on loopback only if ROS_HOSTNAME is localhost. The C++ rosout never does: use
        # the one in our roscore.xml.
        export ROS_HOSTNAME=localhost ROS_ETC_DIR=$ODOMETRY_ROOT/launch/etc
        unset ROS_IP ;;
    *)
        python3 -I -c 'import socket, sys
family, *_, address = socket.getaddrinfo(sys.argv[1], 0)[0]
socket.socket(family).bind(address)' "$address" 2>/dev/null ||
            echo "./ws: $variable=$address is not an address of this machine, so other nodes cannot reach yours: \
unset it" >&2 ;;
esac
unset setup variable address

# Enter the workspace in ODOMETRY_ROOT, and run a command there: enter.bash COMMAND [ARGUMENT...]. The shell
# of ./ws sources it, without a command.
unset PYTHONHOME  # the workspace's Python has its own
# ROS 2 uses the same names for modules and variables.
[ "${ROS_VERSION:-}" != 2 ] ||
    unset PYTHONPATH LD_LIBRARY_PATH CMAKE_PREFIX_PATH AMENT_PREFIX_PATH ROS_VERSION ROS_DISTRO
setup=$ODOMETRY_ROOT/.ws/devel/setup.bash
enter() { . "$setup"; }  # catkin reads the arguments of its caller: a function without any
enter &>/dev/null || {
    # Once more for its message, and without PYTHONPATH to see whether that is the cause.
    reason=$(enter 2>&1 >/dev/null | tail -n 1) || true
    ! (unset PYTHONPATH && enter &>/dev/null) || setup="with PYTHONPATH=$PYTHONPATH $setup"
    echo "./ws: $setup fails: $reason" >&2
    exit 1
}
export PATH=$ODOMETRY_ROOT/.venv/bin:$PATH
# Where a processor has FMA, glibc's sin, cos and atan2 use it, and differ in the last bit: the same motion
# on each x86-64.
[ "$HOSTTYPE" != x86_64 ] || export GLIBC_TUNABLES=${GLIBC_TUNABLES-glibc.cpu.hwcaps=-FMA,-FMA4}
# tf uses numpy.dot, and OpenBLAS adds in another order on processors with AVX-512. Reference BLAS adds as here.
[ "$HOSTTYPE" != x86_64 ] || export OPENBLAS_CORETYPE=${OPENBLAS_CORETYPE-Nehalem}

variable=ROS_IP
[ -z "${ROS_HOSTNAME:-}" ] || variable=ROS_HOSTNAME
address=${!variable:-localhost}
case ${address,,} in
    localhost | localhost.* | *.localhost | localhost[46] | ip6-localhost | ip6-loopback | 127.* | ::1)
        # rospy listens on loopback only if ROS_HOSTNAME is localhost. The C++ rosout never does: use
        # the one in our roscore.xml.
        export ROS_HOSTNAME=localhost ROS_ETC_DIR=$ODOMETRY_ROOT/tools/setup
        unset ROS_IP ;;
    *)
        python3 -I -c 'import socket, sys
family, *_, address = socket.getaddrinfo(sys.argv[1], 0)[0]
socket.socket(family).bind(address)' "$address" 2>/dev/null ||
            echo "./ws: $variable=$address is not an address of this machine, so other nodes cannot reach yours: \
unset it, or give --host one that ip -br address lists" >&2 ;;
esac
unset -f enter; unset setup variable address
[ $# = 0 ] || type -P -- "$1" >/dev/null || { echo "./ws: there is no command $1" >&2; exit 2; }
[ $# = 0 ] || exec "$@"

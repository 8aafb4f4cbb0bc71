# What ./ws does before a command: it enters the workspace in ODOMETRY_ROOT. catkin looks at arguments,
# so that a function without any has to source this.
. "$ODOMETRY_ROOT/.ws/devel/setup.bash"
export PATH=$ODOMETRY_ROOT/.venv/bin:$PATH
if [ -z "${ROS_IP:-}${ROS_HOSTNAME:-}" ]; then
    # Without a name of its own ROS would listen to the whole network.
    export ROS_HOSTNAME=localhost ROS_ETC_DIR=$ODOMETRY_ROOT/launch/etc
fi

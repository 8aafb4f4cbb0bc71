# Before a command: find ROS, install what is missing, build.
for file in system python workspace; do . "$CHECKOUT/tools/setup/$file.bash"; done

mapfile -t PACKAGES < <(cd "$CHECKOUT" && dirname -- {,tools/}*/package.xml)
# ros-* contain the message definitions that rosmsg, rossrv and completion read, lib*-dev the package.xml
# by which these are found; learners' nodes import message_filters and tf2_geometry_msgs. The others depend on
# the rest.
DEBIAN_PARTS=(catkin g++ make python3-dev python3-venv python3-geometry-msgs python3-message-filters
    python3-nav-msgs python3-rosgraph-msgs python3-roslaunch python3-rosmsg python3-rosnode python3-rospy
    python3-rosservice python3-rostest python3-rostopic python3-sensor-msgs python3-std-msgs python3-std-srvs
    python3-tf python3-tf2-geometry-msgs python3-tf2-msgs python3-visualization-msgs librostest-dev
    ros-environment rosbash rosout ros-geometry-msgs ros-nav-msgs ros-rosgraph-msgs ros-roscpp-msg ros-sensor-msgs
    ros-std-msgs ros-std-srvs ros-tf2-msgs ros-visualization-msgs
    libnav-msgs-dev libsensor-msgs-dev libstd-srvs-dev libvisualization-msgs-dev)
TEST_PARTS=(catkin-lint chromium chromium-driver python3-actionlib x11-utils xvfb)
WINDOW_PARTS=(libgl1 libx11-6)

# set_up COMMAND ARGUMENT...: prepare the workspace for a command.
set_up() {
    find_root
    VENV=$ROOT/.venv WORKSPACE=$ROOT/.ws LOG=$ROOT/.ws/setup.log
    cd "$ROOT"
    need_ownership -maxdepth 1
    find_ros
    PARTS=("${DEBIAN_PARTS[@]}") REQUIREMENTS=(requirements.txt)
    add_extras "$@"
    is_debians || PARTS=()
    has_parts "${PARTS[@]}" && has_requirements "${REQUIREMENTS[@]}" && build_is_ready || make_ready "$@"
    [ ! -s "$WORKSPACE/left_out" ] || sed 's,^,./ws: ,' "$WORKSPACE/left_out" >&2
}

# add_extras COMMAND ARGUMENT...: add the PARTS and REQUIREMENTS that only this command needs.
add_extras() {
    case "$* " in
        'test '* | 'pytest '* | python*' -m pytest '*)
            PARTS+=("${TEST_PARTS[@]}" "${WINDOW_PARTS[@]}" rviz)
            REQUIREMENTS+=(test/requirements.txt tools/odometry_tools/requirements-cluster.txt tools/robot_view/requirements.txt) ;;
        'ruff '* | 'vermin '* | 'pre-commit '*) PARTS+=(catkin-lint) REQUIREMENTS+=(test/requirements.txt) ;;
        'dask '* | 'sweep '*'--cluster'*) REQUIREMENTS+=(tools/odometry_tools/requirements-cluster.txt) ;;
        'rosrun tf '*) PARTS+=(libtf-dev tf-tools) ;;
        'rosrun rviz '* | 'rviz '* | 'roslaunch '*' rviz:='[1Tt]*) PARTS+=(rviz) ;;&
        'rosrun sim_turtlebot '*' _gui:='[1Tt]* | 'demo '*'--gui '* | 'roslaunch '*' gui:='[1Tt]*)
            PARTS+=("${WINDOW_PARTS[@]}") ;;&
        'rosrun robot_view view.py '* | 'demo '*'--view '* | 'check '*'--view '* | 'roslaunch '*' view:='[1Tt]*)
            REQUIREMENTS+=(tools/robot_view/requirements.txt) ;;
    esac
}

# make_ready COMMAND ARGUMENT...: install and build what is missing; one call of ./ws at a time.
make_ready() {
    open_workspace "$@"
    need_parts "${PARTS[@]}"
    local what='installing Python packages'
    has_requirements requirements.txt || what='installing PyBullet, 100 MB; on arm64 pip compiles it for minutes'
    has_requirements "${REQUIREMENTS[@]}" || run_step "$what" add_requirements "${REQUIREMENTS[@]}"
    build_is_ready || build
    exec 9>&-
}

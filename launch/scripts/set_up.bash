# What ./ws does before a command: find ROS, install what is missing, build.
for file in install place find_ros check_ros compile make; do
    . "$CHECKOUT/launch/scripts/$file.bash"
done
unset file

PACKAGES=(odometry_common odom_movement_detector test_movement rotate_robot sim_turtlebot launch test)
PYTHON_PARTS=(python3-venv)
# The ros-* are the definitions that rosmsg, rossrv and completion read, of a few kilobytes each; the
# lib*-dev have their package.xml, without which they are not found. Other parts bring the rest.
DEBIAN_PARTS=(catkin g++ make python3-geometry-msgs python3-nav-msgs python3-rosgraph-msgs
    python3-roslaunch python3-rosmsg python3-rosnode python3-rospy python3-rosservice python3-rostest
    python3-rostopic python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf python3-tf2-msgs
    librostest-dev ros-environment rosbash rosout
    ros-geometry-msgs ros-nav-msgs ros-rosgraph-msgs ros-roscpp-msg ros-sensor-msgs ros-std-msgs
    ros-std-srvs ros-tf2-msgs libnav-msgs-dev libsensor-msgs-dev libstd-srvs-dev)
COMPILER_PARTS=(python3-dev)
TEST_PARTS=(catkin-lint chromium chromium-driver iproute2 x11-utils xvfb)
WINDOW_PARTS=(libgl1 libx11-6)
RVIZ_PARTS=(rviz)

# set_up COMMAND ARGUMENT...: make everything ready for a command in the workspace.
set_up() {
    ASKED=("$@")
    find_root
    VENV=$ROOT/.venv
    WORKSPACE=$ROOT/.ws
    LOG=$WORKSPACE/setup.log
    cd "$ROOT"
    find_ros
    choose_parts
    if asks_for_help "$@"; then
        is_ready || help_without_base "$1"
        return
    fi
    is_ready "$@" || make_ready_alone "$@"
}

choose_parts() {
    PARTS=("${PYTHON_PARTS[@]}" "${DEBIAN_PARTS[@]}")
    case $ROS in
        "$USR") ;;
        "$OPT"/*) PARTS=() RVIZ_PARTS=("ros-${ROS##*/}-rviz") ;;
        *) PARTS=() RVIZ_PARTS=() ;;
    esac
}

# asks_for_help COMMAND ARGUMENT...: whether a command of our own is only to say how it is used.
asks_for_help() {
    local word
    case ${1:-} in
        demo | test | bench | soak | sweep)
            for word in "${@:2}"; do
                case $word in -h | --help) return ;; esac
            done ;;
    esac
    return 1
}

# help_without_base COMMAND: nobody wants to install anything only to read what it is for.
help_without_base() {
    usage
    echo
    echo "./ws $1 --help tells more once what is missing is installed and built: ./ws --set-up $1"
    exit
}

# is_ready COMMAND ARGUMENT...: return whether there is nothing to do. It runs in the background,
# since bash forgets a Ctrl-C now and then while it waits for a $(...), but never in `wait`.
is_ready() {
    (
        install_parts() { exit 1; }
        run_step() { exit 1; }
        check_ros() { exit 1; }
        make_ready "$@"
    ) &
    wait $!
}

# make_ready_alone COMMAND ARGUMENT...: do what is to be done, one call of ./ws at a time.
make_ready_alone() {
    need_write
    need_space
    mkdir -p "$WORKSPACE/src"
    exec 9>"$WORKSPACE/lock"
    if ! flock -n 9; then
        echo './ws: another set-up is running; waiting for it' >&2
        flock 9
    fi
    make_ready "$@"
    exec 9>&-
}

make_ready() {
    need_parts "${PARTS[@]}"
    python_is_ready || need_base_python
    build_is_ready || run_step 'building the packages' build
    set_up_extras "$@"
}

need_base_python() {
    check_ros
    need_pybullet
    run_step 'installing PyBullet' make_python
}

# set_up_extras COMMAND ARGUMENT...: what only some commands need; below is the table of both.
set_up_extras() {
    local word
    for word in "$@"; do
        case "$1 $word" in
            'test test' | *screenshots.py) need_for_tests ;;
            'sweep sweep') need_for_sweep ;;
            'bench bench') need_for_sweep; need_for_view ;;
            'sweep --cluster'* | 'dask dask') need_for_cluster ;;
            *' pytest') need_python_for_tests ;;
            *' ruff' | *' vermin' | *' pre-commit') need_parts catkin-lint; need_python tests "$ROOT/test/requirements.txt" ;;
            *' --view' | *' view:='[1Tt]* | *' view.py') need_for_view ;;
            *' --gui' | *' gui:='[1Tt]* | *' _gui:='[1Tt]*) need_parts "${WINDOW_PARTS[@]}" ;;
            *' rviz:='[1Tt]* | *' rviz') need_parts "${RVIZ_PARTS[@]}" ;;
        esac
    done
}

need_for_tests() {
    need_parts "${TEST_PARTS[@]}" "${WINDOW_PARTS[@]}" "${RVIZ_PARTS[@]}"
    need_python_for_tests
}

need_python_for_tests() {
    need_python tests "$ROOT/test/requirements.txt"
    need_for_cluster
    need_for_view
}

need_for_sweep() {
    need_python sweep "$ROOT/launch/requirements-sweep.txt"
}

need_for_cluster() {
    need_for_sweep
    need_python cluster "$ROOT/launch/requirements-cluster.txt"
}

need_for_view() {
    need_python view "$ROOT/sim_turtlebot/requirements-view.txt"
}

# What ./ws does before a command: find ROS, install what is missing, build.
. "$CHECKOUT/launch/scripts/install.bash"
. "$CHECKOUT/launch/scripts/make.bash"

PACKAGES=(odometry_common odom_movement_detector test_movement rotate_robot sim_turtlebot launch test)
PYTHON_PARTS=(python3-venv)
DEBIAN_PARTS=(catkin g++ make python3-geometry-msgs python3-nav-msgs python3-rosgraph-msgs
    python3-roslaunch python3-rosnode python3-rospy python3-rosservice python3-rostest python3-rostopic
    python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf python3-tf2-msgs
    librostest-dev rosbash rosout)
TEST_PARTS=(catkin-lint chromium chromium-driver iproute2 x11-utils xvfb)
WINDOW_PARTS=(libgl1 libx11-6)
RVIZ_PARTS=(ros-robot-state-publisher rviz)

# set_up COMMAND ARGUMENT...: make everything ready for a command in the workspace.
set_up() {
    find_root
    VENV=$ROOT/.venv
    WORKSPACE=$ROOT/.ws
    LOG=$WORKSPACE/setup.log
    cd "$ROOT"
    find_ros
    if asks_for_help "$@"; then
        is_ready || help_without_base "$1"
        return
    fi
    is_ready "$@" || make_ready_alone "$@"
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
        make_ready "$@"
    ) &
    wait $!
}

# make_ready_alone COMMAND ARGUMENT...: do what is to be done, one call of ./ws at a time.
make_ready_alone() {
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
    python_is_ready || run_step 'installing PyBullet' make_python
    build_is_ready || run_step 'building the packages' build
    set_up_extras "$@"
}

# set_up_extras COMMAND ARGUMENT...: what only some commands need; below is the table of both.
set_up_extras() {
    local word
    for word in "$@"; do
        case "$1 $word" in
            'test test' | *screenshots.py | 'bench view') need_for_tests ;;
            'sweep sweep') need_for_sweep ;;
            'sweep --cluster'* | 'dask dask') need_for_cluster ;;
            *' pytest' | *' ruff') need_python tests "$ROOT/test/requirements.txt" ;;
            *' catkin_lint') need_parts catkin-lint ;;
            'bench bench' | *' --view' | *' view:='[1Tt]* | *' view.py') need_for_view ;;
            *' --gui' | *' gui:='[1Tt]* | *' _gui:='[1Tt]*) need_parts "${WINDOW_PARTS[@]}" ;;
            *' rviz:='[1Tt]* | *' rviz') need_parts "${RVIZ_PARTS[@]}" ;;
        esac
    done
}

need_for_tests() {
    need_parts "${TEST_PARTS[@]}" "${WINDOW_PARTS[@]}" "${RVIZ_PARTS[@]}"
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

# find_root: name this folder by a path that may stand in a #! line and in catkin's commands.
find_root() {
    ROOT=$CHECKOUT
    has_odd_characters "$CHECKOUT" || return 0
    # Whoever comes later, with another home, has to find the same name, or all would be built anew.
    local chosen=$CHECKOUT/.ws/root folder
    ROOT=$(cat "$chosen" 2>/dev/null) && [ "$(readlink "$ROOT")" = "$CHECKOUT" ] && return
    for folder in "${XDG_CACHE_HOME:-${HOME:-/var/tmp}/.cache}" /var/tmp; do
        [[ $folder == /* ]] || continue
        folder=$folder/turtlebot2-odometry-$(id -u)
        ROOT=$folder/$(sha256sum <<<"$CHECKOUT" | cut -c 1-16)
        if ! has_odd_characters "$ROOT" && link_root "$folder"; then
            mkdir -p "$CHECKOUT/.ws"
            echo "$ROOT" >"$chosen"
            return
        fi
    done
    fail "the path $CHECKOUT has characters that ROS cannot bear, and there is no place for a link \
to it in ~/.cache or /var/tmp"
}

has_odd_characters() {
    [[ $1 == *[!A-Za-z0-9/._+@~-]* ]]
}

# link_root FOLDER: have ROOT, in a folder that nobody else writes to, lead here.
link_root() {
    mkdir -p -m 700 "$1" 2>/dev/null && [ -O "$1" ] || return
    [ "$(readlink "$ROOT")" = "$CHECKOUT" ] || ln -sfnT "$CHECKOUT" "$ROOT" 2>/dev/null
}

find_ros() {
    command -v dpkg-query >/dev/null ||
        fail "this needs Debian 12, an Ubuntu with Debian's ROS 1 packages, or /opt/ros/noetic"
    if [ -f /opt/ros/noetic/setup.bash ]; then
        PARTS=("${PYTHON_PARTS[@]}")
    else
        PARTS=("${PYTHON_PARTS[@]}" "${DEBIAN_PARTS[@]}")
    fi
}

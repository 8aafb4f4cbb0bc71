# What ./ws does before a command: find ROS, install what is missing, build.
for file in system ros python workspace; do
    . "$CHECKOUT/setup/$file.bash"
done

# All that are here: robot_view and odometry_sweep may be left out.
PACKAGES=("$CHECKOUT"/*/package.xml)
PACKAGES=("${PACKAGES[@]%/package.xml}")
PACKAGES=("${PACKAGES[@]##*/}")
# The ros-* are the definitions that rosmsg, rossrv and completion read, of a few kilobytes each; the
# lib*-dev have their package.xml, without which they are not found. Other parts bring the rest.
DEBIAN_PARTS=(python3-venv catkin g++ make python3-geometry-msgs python3-nav-msgs python3-rosgraph-msgs
    python3-roslaunch python3-rosmsg python3-rosnode python3-rospy python3-rosservice python3-rostest
    python3-rostopic python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf python3-tf2-msgs
    librostest-dev ros-environment rosbash rosout
    ros-geometry-msgs ros-nav-msgs ros-rosgraph-msgs ros-roscpp-msg ros-sensor-msgs ros-std-msgs
    ros-std-srvs ros-tf2-msgs libnav-msgs-dev libsensor-msgs-dev libstd-srvs-dev)
COMPILER_PARTS=(python3-dev)
TEST_PARTS=(catkin-lint chromium chromium-driver iproute2 python3-actionlib python3-dynamic-reconfigure
    python3-message-filters x11-utils xvfb)
WINDOW_PARTS=(libgl1 libx11-6)
RVIZ_PARTS=(rviz)
# Python packages that only some commands need.
declare -A EXTRA_REQUIREMENTS=([tests]=test/requirements.txt [sweep]=odometry_sweep/requirements.txt
    [cluster]=odometry_sweep/requirements-cluster.txt [view]=robot_view/requirements.txt)

# set_up COMMAND ARGUMENT...: make everything ready for a command in the workspace.
set_up() {
    find_root
    VENV=$ROOT/.venv
    WORKSPACE=$ROOT/.ws
    LOG=$WORKSPACE/setup.log
    cd "$ROOT"
    find_ros
    PARTS=() EXTRAS=()
    case $ROS in
        "$USR") PARTS=("${DEBIAN_PARTS[@]}") ;;
        "$OPT"/*) RVIZ_PARTS=("ros-${ROS##*/}-rviz") ;;
        *) RVIZ_PARTS=() ;;
    esac
    if asks_for_help "$@"; then
        is_ready && return
        [ "$1" != demo ] || ! python3 -IB -c "$DEMO_HELP" "$ROOT" 2>/dev/null || exit 0
        usage
        printf '\n%s\n' "./ws $1 --help tells more after: ./ws --set-up $1"
        exit
    fi
    add_extras "$@"
    is_ready || make_ready "$@"
    tell_left_out
}

DEMO_HELP='
import sys
sys.path[:0] = [sys.argv[1] + "/launch/src", sys.argv[1] + "/odometry_common/src"]
from odometry_launch.options import make_parser
make_parser().print_help()'

# asks_for_help COMMAND ARGUMENT...: whether a command of ./ws should only print its usage.
asks_for_help() { is_own "${1:-}" && [[ " ${*:2} " =~ ' '(-h|--help)' ' ]]; }
is_own() { [[ $1 =~ ^(demo|test|bench|sweep)$ ]]; }

# add_extras COMMAND ARGUMENT...: add to PARTS and EXTRAS what only some commands need.
add_extras() {
    local word
    for word in "$@"; do
        case "$1 $word" in
            'test test')
                PARTS+=("${TEST_PARTS[@]}" "${WINDOW_PARTS[@]}" "${RVIZ_PARTS[@]}")
                EXTRAS+=(tests sweep cluster view) ;;
            'bench bench' | 'sweep sweep') EXTRAS+=(sweep) ;;
            'sweep --cluster'* | 'dask dask') EXTRAS+=(sweep cluster) ;;
            *' pytest') EXTRAS+=(tests sweep cluster view) ;;
            *' ruff' | *' vermin' | *' pre-commit') PARTS+=(catkin-lint) EXTRAS+=(tests) ;;
            *' --view' | *' view:='[1Tt]* | *' view.py') EXTRAS+=(view) ;;
            *' --gui' | *' gui:='[1Tt]* | *' _gui:='[1Tt]*) PARTS+=("${WINDOW_PARTS[@]}") ;;
            *' rviz:='[1Tt]* | *' rviz') PARTS+=("${RVIZ_PARTS[@]}") ;;
        esac
    done
}

# is_ready: whether nothing is missing. In the background, since bash forgets a Ctrl-C now and then
# while it waits for a $(...), but never in `wait`.
is_ready() {
    (
        has_parts "${PARTS[@]}" && python_is_ready && build_is_ready || exit
        for extra in "${EXTRAS[@]}"; do
            extra_is_ready "$extra" || exit
        done
    ) &
    wait $!
}

# make_ready COMMAND ARGUMENT...: install and build what is missing, one call of ./ws at a time.
make_ready() {
    local extra
    [ $# = 0 ] || may_exist "$1" || refuse_unknown "$1"
    need_write
    python_is_ready || [ ! -x "$PYTHON" ] || has_pybullet || PARTS+=("${COMPILER_PARTS[@]}")
    mkdir -p "$WORKSPACE/src"
    exec 9>"$WORKSPACE/lock"
    flock -n 9 || {
        announce 'another set-up is running; waiting for it'
        flock 9
    }
    need_parts "${PARTS[@]}"
    python_is_ready || set_up_python
    for extra in "${EXTRAS[@]}"; do
        extra_is_ready "$extra" || run_step "installing Python packages for the $extra" \
            add_python "$VENV/ready-$extra" "$ROOT/${EXTRA_REQUIREMENTS[$extra]}"
    done
    build_is_ready || run_step 'building the packages' build
    exec 9>&-
}

set_up_python() {
    check_ros
    local step='installing PyBullet'
    has_pybullet || {
        need_parts "${COMPILER_PARTS[@]}"
        step="compiling PyBullet, which PyPI lacks for Python $(python_version) on $(uname -m), once; \
it takes about 5 minutes on two processors"
    }
    run_step "$step" make_python
}

# may_exist COMMAND: whether there is such a command, or may be once everything is installed.
may_exist() {
    is_own "$1" || [ "$1" = shell ] || (cd "$CALLED_FROM" && type -P -- "$1" >/dev/null) ||
        [[ $1 =~ ^(ros|rviz|rqt|catkin|tf|py|pip|ruff$|vermin$|pre-commit$|dask) ]]
}

# refuse_unknown COMMAND: end, and name the command of ./ws that is spelled most alike.
refuse_unknown() {
    local close
    close=$(python3 -c "$CLOSE_SPELLING" "$1" 2>/dev/null || true)
    refuse "there is no command $1${close:+; did you mean ./ws $close?}"
}

CLOSE_SPELLING='
import difflib, sys
print(*difflib.get_close_matches(sys.argv[1], "demo test bench sweep shell".split(), 1))'

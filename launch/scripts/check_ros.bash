# What is missing in a ROS that is not ./ws's to change, and how to add it.

# check_ros: end with one line if something is missing.
check_ros() {
    is_debians && return
    local lacks
    mapfile -t lacks < <(load_ros; what_ros_lacks)
    [ ${#lacks[@]} = 0 ] || fail "the ROS in $ROS lacks ${lacks[*]}: $(how_to_add "${lacks[@]}")"
}

what_ros_lacks() {
    local part
    type -P catkin_make >/dev/null || echo catkin
    type -P rosrun >/dev/null || echo rosbash
    for part in "${DEBIAN_PARTS[@]}"; do
        [[ $part != python3-* ]] || tr - _ <<<"${part#python3-}"
    done | xargs "$PYTHON" -c "$MISSING_MODULES"
    "$PYTHON" -c 'import ensurepip, venv' 2>/dev/null || echo python3-venv
    type -P "${CXX:-c++}" >/dev/null || echo g++
    type -P make >/dev/null || echo make
    has_pybullet_wheel || is_kept || "$PYTHON" -c "$HAS_HEADERS" || echo python3-dev
}

MISSING_MODULES='
import importlib.util, sys
for name in sys.argv[1:]:
    if not importlib.util.find_spec(name): print(name)'
HAS_HEADERS='
import os, sys, sysconfig
sys.exit(not os.path.exists(sysconfig.get_path("include") + "/Python.h"))'

# how_to_add PART...: the command that installs what a ROS lacks.
how_to_add() {
    local part names=()
    for part; do
        case $part in
            g++ | make | python3-*) names+=("$part") ;;
            *) names+=("ros-${ROS##*/}-${part//_/-}") ;;
        esac
    done
    case $ROS in
        "$OPT"/*) apt_line "${names[@]}" ;;
        *) echo 'add it where this ROS came from' ;;
    esac
}

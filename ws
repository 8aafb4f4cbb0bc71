#!/usr/bin/env bash
# The front door: sets up what is missing, then runs a command in the workspace.
set -euo pipefail

ROOT=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
VENV=$ROOT/.venv
WORKSPACE=$ROOT/.ws
LOG=$WORKSPACE/setup.log
PACKAGES=(odometry_common odom_movement_detector test_movement rotate_robot sim_turtlebot launch test)
PYTHON_PARTS=(python3-venv)
DEBIAN_PARTS=(catkin g++ make python3-geometry-msgs python3-nav-msgs python3-rosgraph-msgs
    python3-roslaunch python3-rosnode python3-rospy python3-rosservice python3-rostest python3-rostopic
    python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf python3-tf2-msgs
    librostest-dev rosbash rosout)
TEST_PARTS=(catkin-lint chromium chromium-driver iproute2 x11-utils xvfb)
WINDOW_PARTS=(libgl1 libx11-6)
RVIZ_PARTS=(ros-robot-state-publisher rviz)

usage() {
    cat <<'TEXT'
usage: ./ws [--host ADDRESS] COMMAND [ARGUMENT...]

  ./ws demo              drive a simulated TurtleBot 2 two metres; ./ws demo --help tells more
  ./ws test              run all tests; ./ws test --help tells more
  ./ws bench             measure speed and delay, each as a ratio to its limit
  ./ws soak              drive at random for a simulated day and check every step
  ./ws shell             open a shell in the workspace
  ./ws COMMAND...        run any command in the workspace, for example
                           ./ws roslaunch odometry_launch move_two_meters.launch
                           ./ws rostopic echo /odom -n1

ROS listens on this machine only. --host ADDRESS lets other machines in, at this address of this
machine; ROS 1 has no passwords, so that everybody there can drive the robot.

The first use installs ROS from the system's packages and builds; later uses start at once.
TEXT
}

fail() {
    echo "./ws: $1" >&2
    exit 1
}

# run_step TEXT COMMAND...: run a command with its output in the log, and show that it is alive.
run_step() {
    local text=$1 start=$SECONDS pid status=0
    shift
    [ -t 2 ] || echo "./ws: $text ..." >&2
    "$@" >>"$LOG" 2>&1 &
    pid=$!
    trap 'kill $pid 2>/dev/null || true; exit 130' INT TERM HUP
    while [ -t 2 ] && kill -0 $pid 2>/dev/null; do
        printf '\r\033[K./ws: %s ... %d s' "$text" $((SECONDS - start)) >&2
        sleep 0.2
    done
    wait $pid || status=$?
    trap - INT TERM HUP
    if [ $status != 0 ]; then
        [ ! -t 2 ] || echo >&2
        tail -n 15 "$LOG" >&2
        fail "$text failed; the whole output is in $LOG. The next call tries again."
    fi
    [ ! -t 2 ] || printf '\r\033[K./ws: %s: done in %d s\n' "$text" $((SECONDS - start)) >&2
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        env DEBIAN_FRONTEND=noninteractive "$@"
    else
        sudo env DEBIAN_FRONTEND=noninteractive "$@"
    fi
}

has_parts() {
    local states
    states=$(dpkg-query -W -f '${db:Status-Status}\n' "$@" 2>/dev/null) || return 1
    ! grep -qv '^installed$' <<<"$states"
}

need_parts() {
    has_parts "$@" || install_parts "$@"
}

install_parts() {
    if [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
        fail "installing $* needs root or sudo"
    fi
    [ "$(id -u)" = 0 ] || sudo -v
    run_step "installing $# system packages and what they need" apt_install "$@"
}

apt_install() {
    # An earlier set-up may have been killed in the middle of this.
    if [ -n "$(dpkg --audit)" ]; then
        as_root dpkg --configure -a
        as_root apt-get -y -o DPkg::Lock::Timeout=600 --fix-broken install
    fi
    as_root apt-get -q -o DPkg::Lock::Timeout=600 update
    as_root apt-get -q -y -o DPkg::Lock::Timeout=600 install --no-install-recommends "$@"
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

# fingerprint FILE...: what the files contain and where they are.
fingerprint() {
    { echo "$ROOT"; cat "$@"; } | cksum
}

python_is_ready() {
    [ "$(cat "$VENV/ready" 2>/dev/null)" = "$(fingerprint "$ROOT/requirements.txt")" ]
}

make_python() {
    # Half a virtual environment cannot be told from a whole one: begin again.
    rm -rf "$VENV"
    # Debian's ROS modules belong to /usr/bin/python3, whatever python3 is first on PATH.
    /usr/bin/python3 -m venv --system-site-packages "$VENV"
    pip_install "$ROOT/requirements.txt"
    fingerprint "$ROOT/requirements.txt" >"$VENV/ready"
}

pip_install() {
    "$VENV/bin/python3" -m pip install --quiet --disable-pip-version-check -r "$1"
}

# need_python NAME FILE: install optional Python parts once.
need_python() {
    local ready=$VENV/ready-$1
    if [ "$(cat "$ready" 2>/dev/null)" != "$(fingerprint "$2")" ]; then
        run_step "installing Python packages for the $1" pip_install "$2"
        fingerprint "$2" >"$ready"
    fi
}

build_fingerprint() {
    fingerprint "${PACKAGES[@]/%//package.xml}" "${PACKAGES[@]/%//CMakeLists.txt}" \
        "$VENV/ready" ./*/setup.py
}

build_is_ready() {
    [ "$(cat "$WORKSPACE/ready" 2>/dev/null)" = "$(build_fingerprint)" ]
}

build() {
    rm -rf "$WORKSPACE/src" "$WORKSPACE/build" "$WORKSPACE/devel"
    mkdir -p "$WORKSPACE/src"
    # catkin's crawl skips hidden folders, so that these links make no loop.
    local package
    for package in "${PACKAGES[@]}"; do
        ln -s "../../$package" "$WORKSPACE/src/$package"
    done
    PATH=$VENV/bin:$PATH catkin_make -C "$WORKSPACE" -DPYTHON_EXECUTABLE="$VENV/bin/python3"
    build_fingerprint >"$WORKSPACE/ready"
}

set_up() {
    mkdir -p "$WORKSPACE"
    exec 9>"$WORKSPACE/lock"
    if ! flock -n 9; then
        echo './ws: another set-up is running; waiting for it' >&2
        flock 9
    fi
    need_parts "${PARTS[@]}"
    python_is_ready || run_step 'installing PyBullet' make_python
    load_ros
    build_is_ready || run_step 'building the packages' build
    set_up_extras "$@"
    exec 9>&-
}

# set_up_extras COMMAND ARGUMENT...: what only some commands need.
set_up_extras() {
    case " $* " in
        ' test '*) need_parts "${TEST_PARTS[@]}" "${WINDOW_PARTS[@]}" "${RVIZ_PARTS[@]}"
            need_python tests "$ROOT/test/requirements.txt"
            need_python view "$ROOT/sim_turtlebot/requirements-view.txt" ;;
    esac
    case " $* " in
        *' --view '* | *' view:=true '* | *' view.py '*)
            need_python view "$ROOT/sim_turtlebot/requirements-view.txt" ;;
    esac
    case " $* " in
        *' --gui '* | *' gui:=true '* | *' _gui:=true '*) need_parts "${WINDOW_PARTS[@]}" ;;
    esac
    case " $* " in
        *' rviz:=true '*) need_parts "${RVIZ_PARTS[@]}" ;;
    esac
}

load_ros() {
    if [ -f /opt/ros/noetic/setup.bash ]; then
        set +u
        . /opt/ros/noetic/setup.bash
        set -u
    fi
}

enter() {
    set +u
    . "$WORKSPACE/devel/setup.bash"
    set -u
    export PATH=$VENV/bin:$PATH
    if [ -z "${ROS_IP:-}${ROS_HOSTNAME:-}" ]; then
        # Without a name of its own ROS would listen to the whole network.
        export ROS_HOSTNAME=localhost ROS_ETC_DIR=$ROOT/launch/etc
    fi
    export WORKSPACE_SETUP=$WORKSPACE/devel/setup.bash WORKSPACE_BIN=$VENV/bin
    cd "$CALLED_FROM"
}

main() {
    if [ "${1:-}" = --host ]; then
        [ -n "${2:-}" ] || fail '--host needs the address of this machine that others reach'
        export ROS_IP=$2
        shift 2
    fi
    case ${1:-} in
        '' | -h | --help) usage; [ $# != 0 ]; exit ;;
    esac
    CALLED_FROM=$PWD
    cd "$ROOT"
    find_ros
    set_up "$@"
    enter
    case $1 in
        demo) shift; exec "$ROOT/launch/scripts/demo.py" "$@" ;;
        bench) shift; exec python3 "$ROOT/test/benchmarks/run_bench.py" "$@" ;;
        soak) shift; exec python3 "$ROOT/test/soak/run_soak.py" "$@" ;;
        test) shift; exec python3 "$ROOT/test/runner/run_tests.py" "$@" ;;
        shell) shift; exec bash --rcfile "$ROOT/launch/scripts/shell.bash" "$@" ;;
        *) exec "$@" ;;
    esac
}

main "$@"

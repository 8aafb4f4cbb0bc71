#!/usr/bin/env bash
# Install and build what is missing, then run a command in the workspace.
set -euo pipefail

[ "$(uname)" = Linux ] || {  # the next lines would fail there
    echo "./ws: this needs Linux. On $(uname), use the container: docs/container.md" >&2
    exit 1
}
CHECKOUT=$(readlink -f "${BASH_SOURCE[0]}")
CHECKOUT=${CHECKOUT%/*}
. "$CHECKOUT/setup/set_up.bash"

usage() {
    cat <<'TEXT'
usage: ./ws [--host ADDRESS | --set-up] COMMAND [ARGUMENT...]

  ./ws demo              drive a simulated TurtleBot 2 two metres
  ./ws test              run the tests, with -m nightly the long ones
  ./ws bench             measure speed and delay, each as a ratio to its limit
  ./ws sweep             run a tutorial many times without ROS
  ./ws check             judge your own node for a tutorial
  ./ws shell             open a shell in the workspace
  ./ws --set-up COMMAND  only install what that command needs
  ./ws COMMAND...        run any command in the workspace, for example
                         ./ws rostopic echo /odom -n1

demo, test, bench, sweep and check have a --help of their own. The first use
installs what is missing. ROS listens on this machine only; --host ADDRESS lets
other machines connect to this address of this machine. ROS 1 has no passwords:
anyone who can connect can drive the robot.
TEXT
}

# enter: in a function without arguments, since catkin reads the arguments of its caller.
enter() {
    set +u
    . "$ROOT/setup/enter.bash"
    set -u
}

# exec_guarded PROGRAM ARGUMENT...: run a Python program; nothing that it starts outlives this process.
exec_guarded() {
    # catkin's Python too: the guard runs it in a session without the terminal's signals.
    exec "$VENV/bin/python3" -I -S "$ROOT/launch/src/odometry_launch/reaper.py" \
        bash -ec 'enter() { . "$0"; }; enter; exec python3 "$@"' "$ROOT/setup/enter.bash" "$@"
}

only_set_up=false host=
while [[ ${1:-} == -* ]]; do
    case $1 in
        -h | --help) usage; exit ;;
        --set-up) only_set_up=true ;;
        --host)
            host=${2:-}
            [ -n "$host" ] || refuse '--host needs an address of this machine that others can reach'
            shift ;;
        *) refuse "$1 is not one of --host ADDRESS, --set-up, --help" ;;
    esac
    shift
done
$only_set_up || [ $# != 0 ] || { usage; exit 1; }
# These start their own ROS master on this machine, and need no address.
[[ ! ${1:-} =~ ^(demo|test|bench|sweep|check)$ ]] || unset ROS_HOSTNAME ROS_IP
[ -z "$host" ] || { unset ROS_HOSTNAME; export ROS_IP=$host; }
CALLED_FROM=$PWD
set_up "$@"
! $only_set_up || exit 0
cd "$CALLED_FROM"
export ODOMETRY_ROOT=$ROOT
case $1 in
    demo) exec_guarded "$ROOT/launch/script/demo.py" "${@:2}" ;;
    bench) exec_guarded "$ROOT/test/benchmarks/run_bench.py" "${@:2}" ;;
    sweep) exec_guarded "$ROOT/odometry_sweep/script/sweep.py" "${@:2}" ;;
    check) exec_guarded "$ROOT/odometry_check/script/check.py" "${@:2}" ;;
esac
enter
case $1 in
    test) cd "$ROOT"; exec python3 -m pytest -n auto --dist loadfile "${@:2}" ;;
    shell) exec bash --rcfile "$ROOT/setup/shell.bash" "${@:2}" ;;
    dask) export DASK_DISTRIBUTED__WORKER__DAEMON=false ;;  # each run of a launch file is a process
esac
type -P -- "$1" >/dev/null || case $1 in
    rqt*) refuse "there is no command $1: Debian has no rqt. ./ws rosrun robot_view view.py draws plots, too" ;;
    *) refuse "there is no command $1" ;;
esac
exec "$@"

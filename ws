#!/usr/bin/env bash
# The front door: sets up what is missing, then runs a command in the workspace.
set -euo pipefail

IFS= read -r system < <(uname)
if [ "$system" != Linux ]; then  # the next lines would fail there
    echo "./ws: this needs Linux. On $system the container runs: docs/container.md" >&2
    exit 1
fi

# Not by $(...): bash may forget a Ctrl-C while it waits for that.
IFS= read -rd '' CHECKOUT < <(readlink -fz "${BASH_SOURCE[0]}")
CHECKOUT=${CHECKOUT%/*}
. "$CHECKOUT/setup/set_up.bash"
end_by_signals

usage() {
    cat <<'TEXT'
usage: ./ws [--host ADDRESS | --set-up] COMMAND [ARGUMENT...]

  ./ws demo              drive a simulated TurtleBot 2 two metres; ./ws demo --help tells more
  ./ws test              run the tests, with -m nightly the long ones; ./ws test --help tells more
  ./ws bench             measure speed and delay, each as a ratio to its limit
  ./ws sweep             run a tutorial many times without ROS; ./ws sweep --help tells more
  ./ws shell             open a shell in the workspace
  ./ws --set-up COMMAND  only install what that command needs
  ./ws COMMAND...        run any command in the workspace, for example
                           ./ws roslaunch odometry_launch move_two_meters.launch
                           ./ws rostopic echo /odom -n1

ROS listens on this machine only. --host ADDRESS lets other machines in, at this address of this
machine; ROS 1 has no passwords: everybody there can drive the robot.

The first use installs ROS from the system's packages and builds; later uses start at once.
TEXT
}

# enter: in a function without arguments, since catkin reads the arguments of its caller.
enter() {
    set +u
    . "$ROOT/setup/enter.bash"
    set -u
}

# exec_guarded PROGRAM ARGUMENT...: run a Python program; all that it has started ends with this process.
exec_guarded() {
    # While Python starts, Ctrl-C would print a traceback: block signals until then.
    local wait=(env --block-signal=INT,TERM,HUP,QUIT)
    "${wait[@]}" true 2>/dev/null || wait=()  # coreutils before 8.31
    # catkin's Python too: the guard runs it in a session without the terminal's signals.
    exec "${wait[@]}" "$VENV/bin/python3" -I -S "$ROOT/launch/src/odometry_launch/reaper.py" --in-place \
        bash -ec 'enter() { . "$0"; }; enter; exec python3 "$@"' "$ROOT/setup/enter.bash" "$@"
}

main() {
    local only_set_up=false
    CALLED_FROM=$PWD
    while [[ ${1:-} == -* ]]; do
        case $1 in
            -h | --help) usage; exit ;;
            --set-up) only_set_up=true ;;
            --host)
                [ -n "${2:-}" ] || fail '--host needs the address of this machine that others reach'
                unset ROS_HOSTNAME
                export ROS_IP=$2
                shift ;;
            *) refuse "$1 is not one of --host ADDRESS, --set-up, --help" ;;
        esac
        shift
    done
    $only_set_up || [ $# != 0 ] || { usage; exit 1; }
    [[ ${1:-} != shell || ${2:-} != -h && ${2:-} != --help ]] || { usage; exit; }
    [[ ${1:-} != sweep || -d $CHECKOUT/odometry_sweep ]] ||
        refuse './ws sweep needs the package odometry_sweep, which is not here'
    set_up "$@"
    ! $only_set_up || exit 0
    export ODOMETRY_ROOT=$ROOT
    cd "$CALLED_FROM"
    case $1 in
        demo) shift; exec_guarded "$ROOT/launch/script/demo.py" "$@" ;;
        bench) shift; exec_guarded "$ROOT/test/benchmarks/run_bench.py" "$@" ;;
        sweep) shift; exec_guarded "$ROOT/odometry_sweep/script/sweep.py" "$@" ;;
    esac
    enter
    case $1 in
        test) shift; cd "$ROOT"; exec python3 -m pytest -n auto --dist loadfile "$@" ;;
        shell) shift; exec bash --rcfile "$ROOT/setup/shell.bash" "$@" ;;
        *) type -P -- "$1" >/dev/null || refuse_unknown "$1"; exec "$@" ;;
    esac
}

main "$@"

#!/usr/bin/env bash
# usage: ./ws [--host ADDRESS | --set-up] COMMAND [ARGUMENT...]
#
#   ./ws demo              drive a simulated TurtleBot 2 two metres
#   ./ws test              run the tests, with -m nightly the long ones
#   ./ws bench             measure speed and delay, each as a ratio to its limit
#   ./ws sweep             run a tutorial, or your own nodes, many times
#   ./ws check             judge your own node for a tutorial
#   ./ws shell             open a shell in the workspace
#   ./ws --set-up COMMAND  only install what that command needs
#   ./ws COMMAND...        run any command there: ./ws rostopic echo /odom -n1
#
# demo, test, bench, sweep and check have a --help of their own. The first use
# installs what is missing. ROS listens on this machine only; --host ADDRESS, an
# address of it, lets anyone connect who reaches that, and drive the robot.
set -euo pipefail

# The next lines would fail elsewhere.
[ "$(uname)" = Linux ] || { echo "./ws: this needs Linux. On $(uname), use the container: docs/container.md" >&2; exit 1; }
CHECKOUT=$(readlink -f "${BASH_SOURCE[0]}")
CHECKOUT=${CHECKOUT%/*}
. "$CHECKOUT/tools/setup/set_up.bash"
leave_root "$@"

usage() { sed -n '2,/^set/s/^# \?//p' "$CHECKOUT/ws"; }

only_set_up=false host=
while [[ ${1:-} == -* ]]; do
    case $1 in
        -h | --help) usage; exit ;;
        --set-up) only_set_up=true ;;
        --host)
            [ -n "${2:-}" ] || refuse '--host needs an address of this machine that others can reach'
            host=$2; shift ;;
        *) refuse "$1 is not one of --host ADDRESS, --set-up, --help" ;;
    esac
    shift
done
$only_set_up || [ $# != 0 ] || { usage; exit 1; }
# These start their own ROS master on this machine, and need neither an address nor a namespace.
[[ ! ${1:-} =~ ^(demo|test|bench|sweep|check)$ ]] || unset ROS_HOSTNAME ROS_IP ROS_NAMESPACE
[ -z "$host" ] || { unset ROS_HOSTNAME; export ROS_IP=$host; }
set_up "$@"
cd "$OLDPWD"
export ODOMETRY_ROOT=$ROOT
if $only_set_up; then
    [[ ${1:-demo} =~ ^(demo|test|bench|sweep|check|shell)$ ]] ||
        bash "$ROOT/tools/setup/enter.bash" which -- "$1" >/dev/null || refuse "there is no command $1"
    exit 0
fi
case $1 in
    demo) script=tools/odometry_tools/script/demo.py ;;
    bench) script=test/benchmarks/run_bench.py ;;
    sweep | check) script=tools/odometry_tools/script/$1.py ;;
    test) cd "$ROOT"; set -- python3 -m pytest -n auto --dist loadfile "${@:2}" ;;
    shell) set -- bash --rcfile "$ROOT/tools/setup/shell.bash" "${@:2}" ;;
    rqt*) ! is_debians || refuse "there is no command $1: Debian has no rqt. ./ws rosrun robot_view view.py draws plots, too" ;;
    dask)
        export DASK_DISTRIBUTED__WORKER__DAEMON=false  # each run of a launch file is a process
        # Dask listens on every address, and its dashboard even with --host. Options that follow replace these.
        [[ ! ${2:-} =~ ^(scheduler|worker)$ ]] ||
            set -- "${@:1:2}" --host "${host:=127.0.0.1}" --dashboard-address "$host:0" "${@:3}" ;;
esac
# Nothing that a script starts outlives this process. It runs in a session without the terminal's signals.
# Perl blocks them first: while Python starts, Ctrl-C would print a traceback. PERL_BADLANG: a locale that is not
# installed is no matter here.
[ -z "${script:-}" ] || PERL_BADLANG=0 exec perl -MPOSIX=:signal_h -e 'sigprocmask(SIG_BLOCK, POSIX::SigSet->new(
        SIGCHLD, SIGINT, SIGQUIT, SIGHUP, SIGTERM)); exec @ARGV' "$VENV/bin/python3" -I -S "$ROOT/tools/setup/reaper.py" \
    bash "$ROOT/tools/setup/enter.bash" python3 "$ROOT/$script" "${@:2}"
exec bash "$ROOT/tools/setup/enter.bash" "$@"

# Messages of the set-up, its steps, and system packages.

announce() { echo "./ws: $1" >&2; }
fail() { announce "$1"; exit 1; }
refuse() { announce "$1"; exit 2; }  # the command line is wrong
nowhere() { fail "$1. Use the container: docs/container.md"; }

# end_by_signals: end by Ctrl-C and Ctrl-\ even if the command that bash waits for ignores them.
end_by_signals() {
    trap 'trap - INT; kill -INT $$' INT
    trap 'exit 131' QUIT
    trap - TERM HUP
}

# run_step TEXT COMMAND...: run a command with its output in the log, and show progress.
run_step() {
    local text=$1 start=$SECONDS pid status=0
    [ -t 2 ] || announce "$text ..."
    { load_ros && "${@:2}"; } >>"$LOG" 2>&1 &
    pid=$!
    trap 'kill $pid 2>/dev/null || true; exit 130' INT TERM HUP
    while [ -t 2 ] && kill -0 $pid 2>/dev/null; do
        printf '\r./ws: %s ... %d s' "$text" $((SECONDS - start)) >&2
        sleep 0.2
    done
    wait $pid || status=$?
    end_by_signals
    [ ! -t 2 ] || echo >&2
    [ $status = 0 ] || {
        tail -n 20 "$LOG" >&2
        fail "$text failed; the whole output is in $LOG. The next call tries again."
    }
}

has_parts() {
    [ $# = 0 ] || ! type -P dpkg-query >/dev/null ||
        [ -z "$(dpkg-query -W -f '${db:Status-Status}\n' "$@" 2>&1 | grep -vx installed)" ]
}

need_parts() {
    local command="sudo apt-get install --no-install-recommends $*" version
    ! has_parts "$@" || return 0
    is_debians || fail "this needs more of the system: $command"
    [ "$(id -u)" = 0 ] || sudo -v 2>/dev/null ||
        fail "this needs root or sudo; or ask an administrator to run: $command"
    run_step 'updating the package lists' apt_update
    version=$(LC_ALL=C apt-cache policy python3-rospy | awk '/Candidate:/ { print $2 }')
    # Debian 11's rospy does not run on its own Python.
    [[ $version == [0-9]* ]] && dpkg --compare-versions "$version" ge 1.15.13 ||
        nowhere 'the packages of this system contain no ROS 1, or one that is too old'
    run_step "installing $# system packages and their dependencies" \
        apt_get install --no-install-recommends "$@"
}

apt_update() {
    # An earlier set-up may have been killed during an installation.
    [ -z "$(dpkg --audit)" ] || { as_root dpkg --configure -a; apt_get --fix-broken install; }
    apt_get update
}

apt_get() { as_root apt-get -q -y -o DPkg::Lock::Timeout=600 "$@"; }

as_root() {
    set -- env DEBIAN_FRONTEND=noninteractive "$@"
    [ "$(id -u)" = 0 ] || set -- sudo "$@"
    "$@"
}

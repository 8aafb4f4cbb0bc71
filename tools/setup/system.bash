# Messages of the set-up, its steps, and system packages.

LOCK_TIMEOUT=600  # s
LOCKED='get lock|was locked by'  # words of apt-get and dpkg

announce() { echo "./ws: $1" >&2; }
fail() { announce "$1"; exit 1; }
refuse() { announce "$1"; exit 2; }  # the command line is wrong
unsupported() { fail "$1. Use the container: docs/container.md"; }

# leave_root ARGUMENT...: under sudo, go on as its caller, so that no file of a user's clone becomes root's.
leave_root() {
    [ "$(id -u)" != 0 ] || [ "${SUDO_UID:-0}" = 0 ] || [ "$(stat -c %u "$CHECKOUT")" = 0 ] ||
        exec sudo -E -H -u "#$SUDO_UID" -g "#$SUDO_GID" -- "$CHECKOUT/ws" "$@"
}

# End by Ctrl-C and Ctrl-\ even if the command that bash waits for ignores them.
trap 'trap - INT; kill -INT $$' INT
trap 'exit 131' QUIT

# run_step TEXT COMMAND...: run a command with its output in the log; dots show that it is alive.
run_step() {
    announce "$1 ..."
    local dots= status
    [ ! -t 2 ] || { while sleep 1 && kill -0 $$ 2>/dev/null; do printf . >&2; done & dots=$!; disown; }
    set +e
    (set -e; load_ros; "${@:2}") >>"$LOG" 2>&1
    status=$?
    set -e
    [ -z "$dots" ] || { kill "$dots" || true; echo >&2; }
    [ $status = 0 ] || {
        tail -n 20 "$LOG" >&2
        fail "$1 failed; the whole output is in $LOG. The next call tries again."
    }
}

has_parts() {
    [ $# = 0 ] || [ -z "$(dpkg-query -W -f '${db:Status-Status}\n' "$@" 2>&1 | grep -vx installed)" ]
}

need_parts() {
    local part missing=()
    for part; do has_parts "$part" || missing+=("$part"); done
    [ ${#missing[@]} != 0 ] || return 0
    [ "$(id -u)" = 0 ] || sudo -v 2>/dev/null ||
        fail "this needs an administrator to run: sudo apt-get install --no-install-recommends ${missing[*]}"
    run_step 'updating the package lists' apt_update
    local version=$(LC_ALL=C apt-cache policy python3-rospy | awk '/Candidate: [0-9]/ { print $2 }')
    # Debian 11's rospy does not run on its own Python.
    dpkg --compare-versions "$version" ge 1.15.13 ||
        unsupported 'the packages of this system contain no ROS 1, or one that is too old'
    local what="${#missing[@]} system packages"
    [ ${#missing[@]} -gt 9 ] || what=${missing[*]}
    run_step "installing $what and what they need" apt_get install --no-install-recommends "${missing[@]}"
}

apt_update() {
    # An earlier set-up may have been killed during an installation.
    [ -z "$(dpkg --audit)" ] || { patiently as_root dpkg --configure -a; apt_get --fix-broken install; }
    patiently apt_get update
}

# patiently COMMAND...: repeat it while another process, as the system's daily update, holds a lock for which
# dpkg, and apt-get update, do not wait themselves.
patiently() {
    local output status end=$((SECONDS + LOCK_TIMEOUT))
    while true; do
        status=0
        output=$(LC_ALL=C "$@" 2>&1) || status=$?
        [[ $status != 0 && $output =~ $LOCKED && $SECONDS -lt $end ]] || break
        sleep 2
    done
    echo "$output"
    return $status
}

# apt_get removes nothing: apt then fails instead.
apt_get() { as_root apt-get -q -y -o APT::Get::Remove=false -o "DPkg::Lock::Timeout=$LOCK_TIMEOUT" "$@"; }

as_root() { $([ "$(id -u)" = 0 ] || echo sudo) env DEBIAN_FRONTEND=noninteractive "$@"; }

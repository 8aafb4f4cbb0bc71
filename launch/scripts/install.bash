# How ./ws runs the steps of its set-up, and installs parts of the system.
SOURCED=(CMAKE_PREFIX_PATH ROS_PACKAGE_PATH PYTHONPATH PYTHONHOME PKG_CONFIG_PATH LD_LIBRARY_PATH
    AMENT_PREFIX_PATH ROS_VERSION ROS_DISTRO)

fail() {
    echo "./ws: $1" >&2
    exit 1
}

# refuse TEXT: end, since what was typed makes no sense.
refuse() {
    echo "./ws: $1" >&2
    exit 2
}

# nowhere TEXT: end, and say what runs on a system that has no ROS 1.
nowhere() {
    fail "$1. Here, as anywhere, the container runs: docs/container.md"
}

announce() {
    echo "./ws: $1" >&2
}

# end_by_signals: end by Ctrl-C and Ctrl-\ also when the command that bash waits for does not: bash
# would forget them.
end_by_signals() {
    trap 'trap - INT; kill -INT $$' INT
    trap 'exit 131' QUIT
    trap - TERM HUP
}

# run_step TEXT COMMAND...: run a command with its output in the log, and show that it is alive.
# What it makes stands on no workspace that happens to be sourced.
run_step() {
    local text=$1 start=$SECONDS pid status=0 before
    shift
    before=$(wc -l 2>/dev/null <"$LOG" || echo 0)
    [ -t 2 ] || echo "./ws: $text ..." >&2
    (
        has_no_file || unset "${SOURCED[@]}"
        "$@"
    ) >>"$LOG" 2>&1 &
    pid=$!
    trap 'kill $pid 2>/dev/null || true; exit 130' INT TERM HUP
    while [ -t 2 ] && kill -0 $pid 2>/dev/null; do
        printf '\r\033[K./ws: %s ... %d s' "$text" $((SECONDS - start)) >&2
        sleep 0.2
    done
    wait $pid || status=$?
    end_by_signals
    if [ $status != 0 ]; then
        [ ! -t 2 ] || echo >&2
        show_reason $((before + 1)) >&2
        fail "$text failed; the whole output is in $LOG. The next call tries again."
    fi
    [ ! -t 2 ] || printf '\r\033[K./ws: %s: done in %d s\n' "$text" $((SECONDS - start)) >&2
}

# show_reason LINE: show from the log, since that line, what looks like a reason, and the end.
show_reason() {
    local output reason='^E:|error|failed|fatal|not found|no such|cannot|denied|no space|unable'
    output=$(tail -n "+$1" "$LOG")
    {
        grep -iE "$reason" <<<"$output" | head -n 8 || true
        tail -n 12 <<<"$output"
    } | awk '!seen[$0]++'
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        env DEBIAN_FRONTEND=noninteractive "$@"
    else
        sudo env DEBIAN_FRONTEND=noninteractive "$@"
    fi
}

has_parts() {
    type -P dpkg-query >/dev/null || return 0  # with a ROS that brings all that it needs
    local states
    states=$(dpkg-query -W -f '${db:Status-Status}\n' "$@" 2>/dev/null) || return 1
    ! grep -qv '^installed$' <<<"$states"
}

need_parts() {
    [ $# = 0 ] || has_parts "$@" || install_parts "$@"
}

install_parts() {
    local text="installing $# system packages and what they need" missing
    [ $# != 1 ] || text="installing $1 and what it needs"
    is_debians || fail "this needs more of the system: $(apt_line "$@")"
    if [ "$(id -u)" != 0 ] && ! sudo -v 2>/dev/null; then
        mapfile -t missing < <(missing_parts)
        fail "this needs root or sudo, or somebody who has it and types: $(apt_line "${missing[@]}")"
    fi
    run_step 'asking apt what there is' apt_update
    has_ros_packages || nowhere 'ROS 1 is not among the packages of this system, or too old'
    run_step "$text" apt_install "$@"
}

apt_line() {
    echo "sudo apt-get install --no-install-recommends $*"
}

# missing_parts: all that is missing for the command that was typed.
missing_parts() {
    need_parts() {
        local part
        for part; do
            has_parts "$part" || echo "$part"
        done
    }
    need_python() { true; }
    need_parts "${PARTS[@]}"
    python_is_ready || { [ -x "$PYTHON" ] && { has_pybullet_wheel || is_kept; }; } ||
        need_parts "${COMPILER_PARTS[@]}"
    set_up_extras "${ASKED[@]}"
}

apt_update() {
    # An earlier set-up may have been killed in the middle of an installation.
    if [ -n "$(dpkg --audit)" ]; then
        as_root dpkg --configure -a
        as_root apt-get -y -o DPkg::Lock::Timeout=600 --fix-broken install
    fi
    as_root apt-get -q -o DPkg::Lock::Timeout=600 update
}

# has_ros_packages: whether apt has them, and later ones than Debian 11, whose rospy fails there.
has_ros_packages() {
    local version
    version=$(LC_ALL=C apt-cache policy python3-rospy | awk '/Candidate:/ { print $2 }')
    [[ $version == [0-9]* ]] && dpkg --compare-versions "$version" ge 1.15.13
}

apt_install() {
    as_root apt-get -q -y -o DPkg::Lock::Timeout=600 install --no-install-recommends "$@"
}

# The virtual environment .venv, and PyBullet in it. `ready` in it is written last: the fingerprint
# of what it was made from.

# fingerprint FILE...: of the files, of where they are, and of ROS and Python.
fingerprint() {
    { echo "$ROOT"; echo "$ROS"; readlink -f "$PYTHON"; cat "$@"; } | cksum
}

# is_done FILE FINGERPRINT: whether a step is done, by the file that it leaves at its end.
is_done() { [ "$(cat "$1" 2>/dev/null)" = "$2" ]; }

python_is_ready() {
    [ -x "$VENV/bin/python3" ] && is_done "$VENV/ready" "$(fingerprint "$ROOT/requirements.txt")"
}

make_python() {
    rm -f "$VENV/ready"
    rm -rf "$VENV"
    # ROS's modules belong to this Python, whatever python3 is first on PATH.
    "$PYTHON" -m venv --system-site-packages "$VENV"
    printf '%s\n' "$ROS" "$PYTHON" >"$VENV/ros"
    has_pybullet || compile_pybullet
    add_python "$VENV/ready" "$ROOT/requirements.txt"
}

# add_python READY FILE: install the Python packages in a file, and leave another that says so.
add_python() {
    "$VENV/bin/python3" -m pip install --quiet --disable-pip-version-check \
        --find-links "$(wheels)" -r "$2"
    fingerprint "$2" >"$1"
}

# extra_is_ready NAME: whether nothing is missing, as for a package that is left out.
extra_is_ready() {
    [ ! -e "$ROOT/${EXTRA_REQUIREMENTS[$1]}" ] ||
        is_done "$VENV/ready-$1" "$(fingerprint "$ROOT/${EXTRA_REQUIREMENTS[$1]}")"
}

# has_pybullet: whether PyPI has a wheel of it, or an earlier set-up has compiled one.
has_pybullet() {
    case "$(python_version) $(uname -m)" in
        3.[89]' x86_64' | 3.1[01]' x86_64') return ;;
    esac
    compgen -G "$(wheels)/$(pybullet | sed s/==/-/)-cp$(python_version | tr -d .)-*_$(uname -m).whl" \
        >/dev/null
}

python_version() { "$PYTHON" -c 'import sys; print("%d.%d" % sys.version_info[:2])'; }
pybullet() { grep -o '^pybullet==[0-9.]*' "$ROOT/requirements.txt"; }

# wheels: the folder for PyBullet where it has to be compiled, for later workspaces, too.
wheels() {
    local cache=${XDG_CACHE_HOME:-${HOME:-}/.cache}/turtlebot2-odometry-$EUID
    { mkdir -p -m 700 "$cache/wheels" && [ -O "$cache" ]; } 2>/dev/null || cache=$WORKSPACE
    mkdir -p "$cache/wheels"
    echo "$cache/wheels"
}

compile_pybullet() {
    # Debugging symbols would take a fifth of the time, and /tmp may be small. In a session of its
    # own all compilers end together. Without --use-pep517 pip wants the package wheel, which Python
    # 3.11's virtual environments lack. For arm64, GCC fuses multiplications with additions unless told
    # not to: the last digits would differ from those of the wheels for x86-64.
    CFLAGS="${CFLAGS:-} -g0 -ffp-contract=off" TMPDIR=$WORKSPACE setsid "$VENV/bin/python3" -m pip wheel \
        --disable-pip-version-check --no-cache-dir --no-deps --use-pep517 --wheel-dir "$(wheels)" "$(pybullet)" &
    trap "kill -- -$!" TERM
    wait $!
}

# The virtual environment .venv, and what pip installs in it.

# fingerprint FILE...: of the files, of where they are, and of ROS and Python.
fingerprint() {
    { echo "$ROOT"; echo "$ROS"; readlink -f "$PYTHON"; cat "$@"; } | cksum
}

# is_done FILE FINGERPRINT: whether a step is done, by the file that it leaves at its end.
is_done() { [ "$(cat "$1" 2>/dev/null)" = "$2" ]; }

python_is_ready() { [ -x "$VENV/bin/python3" ] && has_requirements requirements.txt; }

# has_requirements FILE: whether they are installed, or of a package that is left out.
has_requirements() { [ ! -e "$1" ] || is_done "$VENV/ready-${1//\//-}" "$(fingerprint "$1")"; }

make_python() {
    rm -rf "$VENV" "$WORKSPACE"/{ready,build,devel}  # what is built starts with the old one
    # What an existing ROS may lack. Its modules belong to this Python, whatever python3 is first on PATH.
    "$PYTHON" -c 'import ensurepip, nav_msgs, rospy, rostest, tf'
    "$PYTHON" -m venv --system-site-packages "$VENV"
    printf '%s\n' "$ROS" "$PYTHON" >"$VENV/ros"
    add_requirements requirements.txt
}

add_requirements() {
    # Where PyBullet is compiled: debugging symbols would take a fifth of the time, and /tmp may be
    # small. In a session of its own all compilers end together. Without --use-pep517 pip wants the
    # package wheel, which Python 3.11's virtual environments lack. For arm64, GCC fuses multiplications
    # with additions unless told not to: the last digits would differ from those of the wheels.
    CFLAGS="${CFLAGS:-} -g0 -ffp-contract=off" TMPDIR=$WORKSPACE setsid "$VENV/bin/python3" -m pip \
        install --quiet --disable-pip-version-check --use-pep517 -r "$1" &
    trap "kill -- -$!" TERM
    wait $!
    fingerprint "$1" >"$VENV/ready-${1//\//-}"
}

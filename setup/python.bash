# The virtual environment .venv, and pip's packages in it.

# fingerprint FILE...: a checksum of the files, their place, ROS and Python.
fingerprint() {
    { echo "$ROOT"; echo "$ROS"; readlink -f "$PYTHON"; cat "$@"; } | cksum
}

# is_done FILE FINGERPRINT: whether a step is done, by the file that it writes last.
is_done() { [ "$(cat "$1" 2>/dev/null)" = "$2" ]; }

python_is_ready() {
    [ -x "$VENV/bin/python3" ] && has_requirements requirements-fork.txt && has_requirements requirements.txt
}

# has_requirements FILE: whether they are installed, or the package has been deleted.
has_requirements() { [ ! -e "$1" ] || is_done "$VENV/ready-${1//\//-}" "$(fingerprint "$1")"; }

make_python() {
    rm -rf "$VENV" "$WORKSPACE"/{ready,build,devel}  # the built scripts start the old one
    # An existing ROS may lack some; its modules belong to this Python, whichever python3 is first on PATH.
    "$PYTHON" -c 'import ensurepip, nav_msgs, rospy, rostest, tf'
    "$PYTHON" -m venv --system-site-packages "$VENV"
    printf '%s\n' "$ROS" "$PYTHON" >"$VENV/ros"
    add_requirements requirements-fork.txt  # apart: pip asks for a hash of each line where one has it
    add_requirements requirements.txt
}

add_requirements() {
    # If pip compiles PyBullet: debugging symbols take a fifth of the time, /tmp may be small, and in a
    # session of their own all compilers end together. Without --use-pep517 pip needs the package wheel,
    # which virtual environments lack. On arm64, GCC would fuse multiplications with additions, which
    # changes the last digits.
    CFLAGS="${CFLAGS:-} -g0 -ffp-contract=off" TMPDIR=$WORKSPACE setsid "$VENV/bin/python3" -m pip \
        install --quiet --disable-pip-version-check --use-pep517 -r "$1" &
    trap "kill -- -$!" TERM
    wait $!
    fingerprint "$1" >"$VENV/ready-${1//\//-}"
}

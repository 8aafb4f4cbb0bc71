# The ROS 1 that ./ws uses, Debian's packages or an existing one, which it leaves unchanged; and pip's
# packages in the virtual environment .venv.
USR=/usr
OPT=/opt/ros

# find_ros: set ROS, its folder, and PYTHON. A workspace keeps the ROS with which it was made, whatever
# a terminal has sourced.
find_ros() {
    PYTHON=$USR/bin/python3
    if [ -s "$VENV/ros" ]; then
        read -r ROS <"$VENV/ros"
    elif [ "${ROS_VERSION:-}" = 1 ] && ROS=$(type -P catkin_make); then
        ROS=${ROS%/bin/catkin_make}
        ROS=${ROS:-$USR}
    else
        for ROS in "$OPT"/{noetic,one} "$USR"; do
            [ ! -f "$ROS/setup.bash" ] || return 0
        done
        type -P dpkg-query >/dev/null || unsupported 'this system has no ROS 1'
    fi
}

is_debians() { [ "$ROS" = "$USR" ]; }

# load_ros: source it, and nothing else, in a subshell.
load_ros() {
    unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH PYTHONPATH PYTHONHOME PKG_CONFIG_PATH LD_LIBRARY_PATH \
        AMENT_PREFIX_PATH ROS_VERSION ROS_DISTRO
    set +u
    is_debians || . "$ROS/setup.bash"
    export PATH=$VENV/bin:$PATH
}

# fingerprint FILE...: a checksum of the files, their place, ROS and Python.
fingerprint() { { printf '%s\n' "$ROOT" "$ROS"; readlink -f "$PYTHON"; cat "$@"; } | cksum; }

# is_done FILE FINGERPRINT: whether a step is done, by the file that it writes last.
is_done() { [ "$(cat "$1" 2>/dev/null)" = "$2" ]; }

# has_requirements FILE...: whether they are installed; a deleted package needs none.
has_requirements() {
    local file
    [ -x "$VENV/bin/python3" ] || return
    for file; do
        [ ! -e "$file" ] || is_done "$VENV/ready-${file//\//-}" "$(fingerprint "$file")" || return
    done
}

make_python() {
    rm -rf "$VENV" "$WORKSPACE"/{ready,build,devel}  # the built scripts start the old one
    # An existing ROS may lack some; its modules belong to this Python, whichever python3 is first on PATH.
    "$PYTHON" -c 'import ensurepip, nav_msgs, rospy, rostest, tf'
    "$PYTHON" -m venv --system-site-packages "$VENV"
    echo "$ROS" >"$VENV/ros"
}

# add_requirements FILE...: install those that are missing; pip refuses a file without one of its hashes.
add_requirements() {
    local file
    has_requirements requirements.txt || make_python
    for file; do
        ! has_requirements "$file" || continue
        # If pip compiles PyBullet: debugging symbols take a fifth of the time, and /tmp may be small. Without
        # --use-pep517 pip needs the package wheel, which virtual environments lack. On arm64, GCC would fuse
        # multiplications with additions, which changes the last digits.
        # The clone's other users do not have this one's ~/.local.
        CFLAGS="${CFLAGS:-} -g0 -ffp-contract=off" TMPDIR=$WORKSPACE PYTHONNOUSERSITE=1 PIP_USER=0 \
            "$VENV/bin/python3" -m pip install --quiet --disable-pip-version-check \
            --use-pep517 --require-hashes -r "$file"
        fingerprint "$file" >"$VENV/ready-${file//\//-}"
    done
}

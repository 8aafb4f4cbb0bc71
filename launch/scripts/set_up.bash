# What ./ws does before a command: find ROS, install what is missing, build.
. "$CHECKOUT/launch/scripts/install.bash"

PACKAGES=(odometry_common odom_movement_detector test_movement rotate_robot sim_turtlebot launch test)
PYTHON_PARTS=(python3-venv)
DEBIAN_PARTS=(catkin g++ make python3-geometry-msgs python3-nav-msgs python3-rosgraph-msgs
    python3-roslaunch python3-rosnode python3-rospy python3-rosservice python3-rostest python3-rostopic
    python3-sensor-msgs python3-std-msgs python3-std-srvs python3-tf python3-tf2-msgs
    librostest-dev rosbash rosout)
TEST_PARTS=(catkin-lint chromium chromium-driver iproute2 x11-utils xvfb)
WINDOW_PARTS=(libgl1 libx11-6)
RVIZ_PARTS=(ros-robot-state-publisher rviz)

# set_up COMMAND ARGUMENT...: make everything ready for a command in the workspace.
set_up() {
    find_root
    VENV=$ROOT/.venv
    WORKSPACE=$ROOT/.ws
    LOG=$WORKSPACE/setup.log
    cd "$ROOT"
    find_ros
    is_ready "$@" || make_ready_alone "$@"
}

# is_ready COMMAND ARGUMENT...: return whether there is nothing to do. It runs in the background,
# since bash forgets a Ctrl-C now and then while it waits for a $(...), but never in `wait`.
is_ready() {
    (
        install_parts() { exit 1; }
        run_step() { exit 1; }
        make_ready "$@"
    ) &
    wait $!
}

# make_ready_alone COMMAND ARGUMENT...: do what is to be done, one call of ./ws at a time.
make_ready_alone() {
    mkdir -p "$WORKSPACE/src"
    exec 9>"$WORKSPACE/lock"
    if ! flock -n 9; then
        echo './ws: another set-up is running; waiting for it' >&2
        flock 9
    fi
    make_ready "$@"
    exec 9>&-
}

make_ready() {
    need_parts "${PARTS[@]}"
    python_is_ready || run_step 'installing PyBullet' make_python
    build_is_ready || run_step 'building the packages' build
    set_up_extras "$@"
}

# set_up_extras COMMAND ARGUMENT...: what only some commands need; below is the table of both.
set_up_extras() {
    local word
    for word in "$@"; do
        case "$1 $word" in
            'test test' | *screenshots.py | 'bench view') need_for_tests ;;
            *' pytest' | *' ruff') need_python tests "$ROOT/test/requirements.txt" ;;
            *' catkin_lint') need_parts catkin-lint ;;
            'bench bench' | *' --view' | *' view:='[1Tt]* | *' view.py') need_for_view ;;
            *' --gui' | *' gui:='[1Tt]* | *' _gui:='[1Tt]*) need_parts "${WINDOW_PARTS[@]}" ;;
            *' rviz:='[1Tt]* | *' rviz') need_parts "${RVIZ_PARTS[@]}" ;;
        esac
    done
}

need_for_tests() {
    need_parts "${TEST_PARTS[@]}" "${WINDOW_PARTS[@]}" "${RVIZ_PARTS[@]}"
    need_python tests "$ROOT/test/requirements.txt"
    need_for_view
}

need_for_view() {
    need_python view "$ROOT/sim_turtlebot/requirements-view.txt"
}

# find_root: name this folder by a path that may stand in a #! line and in catkin's commands.
find_root() {
    ROOT=$CHECKOUT
    has_odd_characters "$CHECKOUT" || return 0
    # Whoever comes later, with another home, has to find the same name, or all would be built anew.
    local chosen=$CHECKOUT/.ws/root folder
    ROOT=$(cat "$chosen" 2>/dev/null) && [ "$(readlink "$ROOT")" = "$CHECKOUT" ] && return
    for folder in "${XDG_CACHE_HOME:-${HOME:-/var/tmp}/.cache}" /var/tmp; do
        [[ $folder == /* ]] || continue
        folder=$folder/turtlebot2-odometry-$(id -u)
        ROOT=$folder/$(sha256sum <<<"$CHECKOUT" | cut -c 1-16)
        if ! has_odd_characters "$ROOT" && link_root "$folder"; then
            mkdir -p "$CHECKOUT/.ws"
            echo "$ROOT" >"$chosen"
            return
        fi
    done
    fail "the path $CHECKOUT has characters that ROS cannot bear, and there is no place for a link \
to it in ~/.cache or /var/tmp"
}

has_odd_characters() {
    [[ $1 == *[!A-Za-z0-9/._+@~-]* ]]
}

# link_root FOLDER: have ROOT, in a folder that nobody else writes to, lead here.
link_root() {
    mkdir -p -m 700 "$1" 2>/dev/null && [ -O "$1" ] || return
    [ "$(readlink "$ROOT")" = "$CHECKOUT" ] || ln -sfnT "$CHECKOUT" "$ROOT" 2>/dev/null
}

find_ros() {
    command -v dpkg-query >/dev/null ||
        fail "this needs Debian 12, an Ubuntu with Debian's ROS 1 packages, or /opt/ros/noetic"
    if [ -f /opt/ros/noetic/setup.bash ]; then
        PARTS=("${PYTHON_PARTS[@]}")
    else
        PARTS=("${PYTHON_PARTS[@]}" "${DEBIAN_PARTS[@]}")
    fi
}

load_ros() {
    if [ -f /opt/ros/noetic/setup.bash ]; then
        set +u
        . /opt/ros/noetic/setup.bash
        set -u
    fi
}

# fingerprint FILE...: what the files contain and where they are.
fingerprint() {
    { echo "$ROOT"; cat "$@"; } | cksum
}

python_is_ready() {
    [ "$(cat "$VENV/ready" 2>/dev/null)" = "$(fingerprint "$ROOT/requirements.txt")" ]
}

make_python() {
    # Half a virtual environment cannot be told from a whole one: begin again.
    rm -rf "$VENV"
    # Debian's ROS modules belong to /usr/bin/python3, whatever python3 is first on PATH.
    /usr/bin/python3 -m venv --system-site-packages "$VENV"
    pip_install "$ROOT/requirements.txt"
    fingerprint "$ROOT/requirements.txt" >"$VENV/ready"
}

pip_install() {
    "$VENV/bin/python3" -m pip install --quiet --disable-pip-version-check -r "$1"
}

# need_python NAME FILE: install optional Python parts once.
need_python() {
    local ready=$VENV/ready-$1
    if [ "$(cat "$ready" 2>/dev/null)" != "$(fingerprint "$2")" ]; then
        run_step "installing Python packages for the $1" pip_install "$2"
        fingerprint "$2" >"$ready"
    fi
}

build_fingerprint() {
    local others
    mapfile -d '' -t others < <(find "$WORKSPACE/src" -mindepth 2 -name package.xml -print0 | sort -z)
    fingerprint "${PACKAGES[@]/%//package.xml}" "${PACKAGES[@]/%//CMakeLists.txt}" \
        "$VENV/ready" ./*/setup.py "${others[@]}"
}

build_is_ready() {
    [ -f "$WORKSPACE/devel/setup.bash" ] &&
        [ "$(cat "$WORKSPACE/ready" 2>/dev/null)" = "$(build_fingerprint)" ]
}

build() {
    load_ros
    rm -rf "$WORKSPACE/ready" "$WORKSPACE/build" "$WORKSPACE/devel"
    mkdir "$WORKSPACE/build"
    # A package of an earlier version may be gone. What else is there is the user's.
    find "$WORKSPACE/src" -maxdepth 1 -lname '../../*' -xtype l -delete
    # catkin's crawl skips hidden folders, so that these links make no loop.
    local package
    for package in "${PACKAGES[@]}"; do
        ln -sfnT "../../$package" "$WORKSPACE/src/$package"
    done
    # CMake believes PWD where it is a name of its folder, and else takes the one without links.
    cd "$WORKSPACE/build"
    PATH=$VENV/bin:$PATH catkin_make -C "$WORKSPACE" -DPYTHON_EXECUTABLE="$VENV/bin/python3"
    cd "$ROOT"
    build_fingerprint >"$WORKSPACE/ready"
}

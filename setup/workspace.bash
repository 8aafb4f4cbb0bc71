# The catkin workspace .ws, and a path of this folder that ROS can handle.

# find_root: set ROOT, a path of this folder that works in a #! line and in catkin's commands.
find_root() {
    ROOT=$CHECKOUT
    [[ $CHECKOUT == *[!A-Za-z0-9/._+@~-]* ]] || return 0
    # The same link for every user and home, or each would build the workspace again.
    local owner folder
    owner=$(stat -c %u "$CHECKOUT")
    folder=/var/tmp/turtlebot2-odometry-$owner
    ROOT=$folder/$(sha256sum <<<"$CHECKOUT" | cut -c 1-16)
    mkdir -m 755 "$folder" 2>/dev/null || true
    [[ $(stat -c %u "$folder") =~ ^($owner|0)$ ]] && {
        [ "$(readlink "$ROOT")" = "$CHECKOUT" ] || ln -sfnT "$CHECKOUT" "$ROOT" 2>/dev/null
    } || fail "ROS cannot handle the path $CHECKOUT, and no link to it can be made in $folder"
}

# build_fingerprint: of the build files of these packages, and of the compiled files of the user's.
build_fingerprint() {
    fingerprint "$VENV/ready-requirements.txt" ./*/{package.xml,CMakeLists.txt,setup.py} <(
        find -L "$WORKSPACE/src" -regextype egrep -regex \
            '.*/(package\.xml|CMakeLists\.txt|setup\.py|[^/]*\.(c|cc|cpp|h|hpp|msg|srv|action|cfg))' \
            -printf '%p %T@\n' | sort)
}

build_is_ready() { [ -d "$WORKSPACE/devel" ] && is_done "$WORKSPACE/ready" "$(build_fingerprint)"; }

build() {
    BUILT_FROM=$(build_fingerprint)
    rm -f "$WORKSPACE/ready"
    ! is_debians || (need_parts $(apt-cache pkgnames | (load_ros; run_packages depends))) ||
        announce 'continuing without these dependencies of packages in .ws/src'
    run_step 'building the packages' build_all
}

build_all() {
    mkdir -p "$WORKSPACE"/{ours,build/ours}
    ln -sfn -t "$WORKSPACE/ours" "${PACKAGES[@]/#/$ROOT/}"
    # CMake uses PWD if it names its folder, and otherwise a path without links.
    cd "$WORKSPACE/build/ours"
    catkin_make -C "$WORKSPACE" --source "$WORKSPACE/ours" --build "$WORKSPACE/build/ours" \
        -DPYTHON_EXECUTABLE="$VENV/bin/python3" && run_packages build && echo "$BUILT_FROM" >"$WORKSPACE/ready"
}

run_packages() { python3 "$ROOT/setup/packages.py" "$1" "$WORKSPACE" "${PACKAGES[@]/#/$ROOT/}"; }

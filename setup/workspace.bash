# The catkin workspace .ws, and the path under which ROS knows this folder. `ready` in it is written
# last: the fingerprint of what it was built from.

# find_root: set ROOT, a path of this folder that may stand in a #! line and in catkin's commands.
find_root() {
    ROOT=$CHECKOUT
    [[ $CHECKOUT == *[!A-Za-z0-9/._+@~-]* ]] || return 0
    # The same link for every user and home, or the workspace would be built again.
    local owner folder
    owner=$(stat -c %u "$CHECKOUT")
    folder=/var/tmp/turtlebot2-odometry-$owner
    ROOT=$folder/$(sha256sum <<<"$CHECKOUT" | cut -c 1-16)
    mkdir -m 755 "$folder" 2>/dev/null || true
    [[ $(stat -c %u "$folder") =~ ^($owner|0)$ ]] && {
        [ "$(readlink "$ROOT")" = "$CHECKOUT" ] || ln -sfnT "$CHECKOUT" "$ROOT" 2>/dev/null
    } || fail "ROS cannot handle the path $CHECKOUT, and $folder, for a link to it, cannot be written"
}

# need_write: end with one line if the set-up would end with `permission denied`.
need_write() {
    local path
    for path in "$CHECKOUT" "$CHECKOUT"/.ws{,/src,/lock,/setup.log} "$CHECKOUT/.venv"; do
        [ ! -e "$path" ] || [ -w "$path" ] || fail "you cannot write to $path, which belongs to \
$(stat -c %U "$path"): clone the project into a folder of your own"
    done
}

build_fingerprint() {
    local theirs
    mapfile -d '' -t theirs < <(find "$WORKSPACE/src" -mindepth 2 -name package.xml -print0 | sort -z)
    fingerprint "${PACKAGES[@]/%//package.xml}" "${PACKAGES[@]/%//CMakeLists.txt}" \
        "$VENV/ready" ./*/setup.py "${theirs[@]}"
}

build_is_ready() {
    [ -f "$WORKSPACE/devel/setup.bash" ] && is_done "$WORKSPACE/ready" "$(build_fingerprint)"
}

build() {
    rm -f "$WORKSPACE/ready"
    rm -rf "$WORKSPACE/build" "$WORKSPACE/devel"
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
    load_ros
    PATH=$VENV/bin:$PATH catkin_make -C "$WORKSPACE" -DPYTHON_EXECUTABLE="$VENV/bin/python3"
    cd "$ROOT"
    build_fingerprint >"$WORKSPACE/ready"
}

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
    } || fail "ROS cannot handle the path $CHECKOUT, and no link to it can be made in $folder"
}

# build_fingerprint: of how our packages are built, and of what is compiled of the user's.
build_fingerprint() {
    fingerprint "$VENV/ready-requirements.txt" ./*/{package.xml,CMakeLists.txt,setup.py} <(
        find -L "$WORKSPACE/src" -regextype egrep -regex \
            '.*/(package\.xml|CMakeLists\.txt|setup\.py|[^/]*\.(c|cc|cpp|h|hpp|msg|srv|action|cfg))' \
            -printf '%p %T@\n' | sort)
}

build_is_ready() { [ -d "$WORKSPACE/devel" ] && is_done "$WORKSPACE/ready" "$(build_fingerprint)"; }

build() {
    local part missing=()
    BUILT_FROM=$(build_fingerprint)
    rm -f "$WORKSPACE/ready"
    # Earlier versions had links to our packages there. What else there is, is the user's.
    find "$WORKSPACE/src" -maxdepth 1 -lname '../../*' ! -lname '../../*/*' -delete
    for part in $(! is_debians || apt-cache pkgnames | (load_ros && run_packages depends)); do
        has_parts "$part" || missing+=("$part")
    done
    [ ${#missing[@]} = 0 ] || {
        announce "packages in .ws/src depend on ${missing[*]}"
        (need_parts "${missing[@]}") || announce 'going on without them'
    }
    run_step 'building the packages' build_all
}

build_all() {
    mkdir -p "$WORKSPACE"/{ours,build/ours}
    for package in "${PACKAGES[@]}"; do
        ln -sfnT "$ROOT/$package" "$WORKSPACE/ours/$package"
    done
    # CMake believes PWD where it is a name of its folder, and else takes the one without links.
    cd "$WORKSPACE/build/ours"
    catkin_make -C "$WORKSPACE" --source "$WORKSPACE/ours" --build "$WORKSPACE/build/ours" \
        -DPYTHON_EXECUTABLE="$VENV/bin/python3" && run_packages build || return
    echo "$BUILT_FROM" >"$WORKSPACE/ready"
}

run_packages() { python3 "$ROOT/setup/packages.py" "$1" "$WORKSPACE" "${PACKAGES[@]/#/$ROOT/}"; }

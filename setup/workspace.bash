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
    mapfile -d '' -t theirs < <(find "$WORKSPACE/src" -mindepth 2 \
        \( -name package.xml -o -name CMakeLists.txt \) -print0 | sort -z)
    fingerprint "${PACKAGES[@]/%//package.xml}" "${PACKAGES[@]/%//CMakeLists.txt}" \
        "$VENV/ready" ./*/setup.py "${theirs[@]}"
}

build_is_ready() {
    [ -f "$WORKSPACE/devel/setup.bash" ] && is_done "$WORKSPACE/ready" "$(build_fingerprint)"
}

build() {
    rm -f "$WORKSPACE/ready" "$WORKSPACE/left_out"
    # A package of an earlier version may be gone. What else is there is the user's.
    find "$WORKSPACE/src" -maxdepth 1 -lname '../../*' -xtype l -delete
    # catkin's crawl skips hidden folders, so that these links make no loop.
    local package
    for package in "${PACKAGES[@]}"; do
        ln -sfnT "../../$package" "$WORKSPACE/src/$package"
    done
    load_ros
    local left_out='' culprit
    until build_without "$left_out"; do
        culprit=$(awk "$CULPRIT" "$WORKSPACE/build.log")
        # Without one of ours there is nothing to run.
        [ -n "$culprit" ] && ! grep -qs "<name>${culprit%%:*}</name>" ./*/package.xml || return 1
        echo "$culprit" >>"$WORKSPACE/left_out"
        left_out+=";${culprit%%:*}"
    done
    build_fingerprint >"$WORKSPACE/ready"
}

# build_without PACKAGES: build all packages but these, which semicolons separate.
build_without() {
    rm -rf "$WORKSPACE/build" "$WORKSPACE/devel"
    mkdir "$WORKSPACE/build"
    # CMake believes PWD where it is a name of its folder, and else takes the one without links.
    (cd "$WORKSPACE/build" && PATH=$VENV/bin:$PATH catkin_make -C "$WORKSPACE" \
        -DPYTHON_EXECUTABLE="$VENV/bin/python3" -DCATKIN_BLACKLIST_PACKAGES="$1") 2>&1 |
        tee "$WORKSPACE/build.log"
}

# The package that CMake could not configure, and why: the paragraph below "CMake Error at".
CULPRIT='
/^-- \+\+\+ processing catkin package: / { package = $NF; gsub("\047", "", package) }
/^CMake Error/ && package { failed = 1; next }
failed && NF { sub(/^ +/, ""); reason = reason " " $0 }
failed && !NF && reason { sub(/:$/, "", reason); print package ":" reason; exit }'

# tell_left_out: name the packages that are not built, and why.
tell_left_out() {
    local package
    [ ! -s "$WORKSPACE/left_out" ] || while read -r package; do
        announce "left out $package. Once you have installed what it lacks, delete .ws/ready"
    done <"$WORKSPACE/left_out"
}

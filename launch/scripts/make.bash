# What ./ws makes: the virtual environment .venv and the workspace .ws. In each of them a file
# `made` names what must not be gone, and `ready`, which is written last, is the fingerprint of what
# it was made of.

# fingerprint FILE...: what the files contain and where they are, and of which ROS and Python.
fingerprint() {
    { echo "$ROOT"; echo "$ROS"; readlink -f "$PYTHON"; cat "$@"; } | cksum
}

# is_done FILE FINGERPRINT: whether a step is done, according to the file that it leaves at its end.
is_done() {
    [ "$(cat "$1" 2>/dev/null)" = "$2" ]
}

# is_whole FOLDER: whether nothing is gone of what was made there, which a list names.
is_whole() {
    local thing things
    [ -s "$1/made" ] || return
    mapfile -t things <"$1/made"
    for thing in "${things[@]}"; do
        [ -s "$thing" ] || return
    done
}

python_is_ready() {
    is_whole "$VENV" && is_done "$VENV/ready" "$(fingerprint "$ROOT/requirements.txt")"
}

make_python() {
    # Half a virtual environment cannot be told from a whole one: begin again.
    rm -f "$VENV/ready"
    rm -rf "$VENV"
    # ROS's modules belong to this one, whatever python3 is first on PATH.
    "$PYTHON" -m venv --system-site-packages "$VENV"
    printf '%s\n' "$ROS" "$PYTHON" >"$VENV/ros"
    add_python "$VENV/ready" "$ROOT/requirements.txt"
}

# add_python READY FILE: install the Python parts in a file, and leave another that says so.
add_python() {
    local kept=()
    [ -z "${WHEELS:-}" ] || kept=(--find-links "$WHEELS")
    "$VENV/bin/python3" -m pip install --quiet --disable-pip-version-check "${kept[@]}" -r "$2"
    list_python >"$VENV/made"
    fingerprint "$2" >"$1"
}

list_python() {
    echo "$VENV/bin/python3"
    find "$VENV"/lib/python3*/site-packages -mindepth 1 -maxdepth 1 -size +0 \
        ! -name '*.dist-info' ! -name __pycache__
}

# need_python NAME FILE: install optional Python parts once, unless their package is left out.
need_python() {
    local ready=$VENV/ready-$1
    [ ! -e "$2" ] || is_done "$ready" "$(fingerprint "$2")" ||
        run_step "installing Python packages for the $1" add_python "$ready" "$2"
}

build_fingerprint() {
    local others
    mapfile -d '' -t others < <(find "$WORKSPACE/src" -mindepth 2 -name package.xml -print0 | sort -z)
    fingerprint "${PACKAGES[@]/%//package.xml}" "${PACKAGES[@]/%//CMakeLists.txt}" \
        "$VENV/ready" ./*/setup.py "${others[@]}"
}

build_is_ready() {
    is_whole "$WORKSPACE" && is_done "$WORKSPACE/ready" "$(build_fingerprint)"
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
    list_build >"$WORKSPACE/made"
    build_fingerprint >"$WORKSPACE/ready"
}

list_build() {
    find -L "$WORKSPACE/src" -maxdepth 2 -name package.xml
    find "$WORKSPACE/devel" ! -type d -size +0 ! -name '*.pyc'
}

# The catkin workspace .ws, and a path of this folder that ROS can handle.

# find_root: set ROOT, a path of this folder that works in a #! line and in catkin's commands.
find_root() {
    ROOT=$CHECKOUT
    [[ $CHECKOUT == *[!A-Za-z0-9/._+@~-]* || ${#CHECKOUT} -gt 200 ]] || return 0
    # The same link for every user and home, or each would build the workspace again.
    local owner folder
    owner=$(stat -c %u "$CHECKOUT")
    folder=/var/tmp/turtlebot2-odometry-$owner
    ROOT=$folder/$(sha256sum <<<"$CHECKOUT" | cut -c 1-16)
    # A folder of another user would keep everybody out.
    if [[ $(id -u) =~ ^($owner|0)$ ]]; then mkdir -m 755 "$folder" 2>/dev/null || true; fi
    [[ $(stat -c %u "$folder" 2>/dev/null) =~ ^($owner|0)$ ]] && {
        [ "$(readlink "$ROOT")" = "$CHECKOUT" ] || ln -sfnT "$CHECKOUT" "$ROOT" 2>/dev/null
    } || fail "ROS cannot handle the path $CHECKOUT, and no link to it can be made in $folder"
}

DPKG=/var/lib/dpkg/status
# need_ownership FIND_OPTION...: the owner of the clone can write what ./ws made there. After sudo it may be root's.
need_ownership() {
    [ -O . ] || return 0
    local path others=()
    for path in .ws .venv runs; do
        [ -z "$(find "$path" "$@" -path .ws/src -prune -o ! -writable ! -type l ! -uid "$(id -u)" \
            -print -quit 2>/dev/null)" ] || others+=("$ROOT/$path")
    done
    [ ${#others[@]} = 0 ] || fail "these belong to another user, as after sudo: sudo chown -R $(id -un): ${others[*]}"
}

# open_workspace COMMAND ARGUMENT...: make its folder and take its lock.
open_workspace() {
    need_ownership
    local reason
    reason=$( (mkdir -p "$WORKSPACE/src" && : >>"$WORKSPACE/lock" && : >>"$LOG") 2>&1 ) ||
        fail "not everything that ${1:-demo} needs is installed and built, and you cannot write $ROOT \
(${reason##*: }): ask $(stat -c %U .) to type: $ROOT/ws --set-up ${*:-demo}"
    exec 9>"$WORKSPACE/lock"
    flock -n 9 || { announce 'another set-up is running; waiting for it'; flock 9; }
}

# The names of files that a C++ compiler reads, or that say what is built.
SOURCES='(package\.xml|[A-Z]+_IGNORE|CMakeLists\.txt|setup\.py|[^/]*\.(c|cc|cpp|cxx|h|hh|hpp|hxx|inl|ipp|cmake|in|proto|msg|srv|action|cfg))'

# build_fingerprint: of the build files of these packages, and of the sources and the names of the
# scripts of the user's. %C: a replaced file may have the same time of change.
build_fingerprint() {
    local -x LC_ALL=C  # the order of files
    fingerprint "$VENV/ready-requirements.txt" ./{,tools/}*/{package.xml,CMakeLists.txt,setup.py} <(
        find -L "$WORKSPACE/src" -regextype egrep -regex ".*/$SOURCES" -printf '%p %T@ %C@\n' \
            -o -name '*.py' -printf '%p\n' 2>/dev/null | sort)
}

build_is_ready() {
    [ -d "$WORKSPACE/devel" ] && [ -s "$WORKSPACE/ready" ] || return
    [ -w "$WORKSPACE" ] || return 0  # who cannot build uses what is built
    is_done "$WORKSPACE/ready" "$(build_fingerprint)" && {
        # What was missing may have been installed since.
        [ ! -s "$WORKSPACE/left_out" ] || [ ! "$DPKG" -nt "$WORKSPACE/ready" ]
    }
}

build() {
    BUILT_FROM=$(build_fingerprint)
    rm -f "$WORKSPACE/ready"
    ! is_debians || need_depends
    run_step 'building the packages' build_all
}

# need_depends: install what the packages in .ws/src depend on, as far as ROS and rosdep know it.
need_depends() {
    local parts
    parts=$(apt-cache pkgnames | (load_ros; run_packages depends))
    { has_parts $parts || may_install $parts && (need_parts $parts); } ||
        announce 'continuing without these dependencies of packages in .ws/src'
}

# may_install PACKAGE...: on a terminal, ask.
may_install() {
    local part answer
    [ -t 0 ] && [ -t 2 ] || return 0
    announce 'packages in .ws/src depend on these system packages:'
    for part; do has_parts "$part" || echo "    $part" >&2; done
    read -r -p './ws: install them? [Y/n] ' answer || answer=no
    [[ ${answer:-y} == [Yy]* ]] || { announce "to be asked again: rm $WORKSPACE/ready"; return 1; }
}

# our_packages: the folders that ours leads to; catkin_make adds a CMakeLists.txt.
our_packages() { find "$WORKSPACE/ours" -type l ! -name CMakeLists.txt -printf '%l\n' | sort; }

build_all() {
    local before
    mkdir -p "$WORKSPACE/ours"
    before=$(our_packages)
    rm -rf "$WORKSPACE/ours"
    mkdir "$WORKSPACE/ours"
    ln -s -t "$WORKSPACE/ours" "${PACKAGES[@]/#/$ROOT/}"
    # A package of ours that has moved, or gone, would leave its programs.
    [ "$before" = "$(our_packages)" ] || rm -rf "$WORKSPACE"/{build,devel}
    mkdir -p "$WORKSPACE/build/ours"
    # CMake uses PWD if it names its folder, and otherwise a path without links.
    cd "$WORKSPACE/build/ours"
    catkin_make -C "$WORKSPACE" --source "$WORKSPACE/ours" --build "$WORKSPACE/build/ours" \
        -DPYTHON_EXECUTABLE="$VENV/bin/python3" && run_packages build && echo "$BUILT_FROM" >"$WORKSPACE/ready"
}

run_packages() { python3 "$ROOT/tools/setup/packages.py" "$1" "$WORKSPACE" "$SOURCES" "${PACKAGES[@]/#/$ROOT/}"; }

# Where ./ws works: the clone, under a name that ROS can bear, and the cache that outlives it.

# What outlives a clone is in the first of these that can be written.
CACHES=("${XDG_CACHE_HOME:-${HOME:-/var/tmp}/.cache}/turtlebot2-odometry-$EUID"
    "/var/tmp/turtlebot2-odometry-$EUID")

# find_root: name this folder by a path that may stand in a #! line and in catkin's commands.
find_root() {
    ROOT=$CHECKOUT
    has_odd_characters "$CHECKOUT" || return 0
    # Whoever comes later, with another home, has to find the same name, or all would be built anew.
    local chosen=$CHECKOUT/.ws/root folder
    ROOT=$(cat "$chosen" 2>/dev/null) && [ "$(readlink "$ROOT")" = "$CHECKOUT" ] && return
    need_write
    for folder in "${CACHES[@]}"; do
        ROOT=$folder/$(sha256sum <<<"$CHECKOUT" | cut -c 1-16)
        if ! has_odd_characters "$ROOT" && is_ours "$folder" && link_root; then
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

# is_ours FOLDER: make it, if need be, and return whether it is a place that nobody else writes to.
is_ours() {
    [[ $1 == /* ]] && mkdir -p -m 700 "$1" 2>/dev/null && [ -O "$1" ] && [ -w "$1" ]
}

# link_root: have ROOT lead here.
link_root() {
    [ "$(readlink "$ROOT")" = "$CHECKOUT" ] || ln -sfnT "$CHECKOUT" "$ROOT" 2>/dev/null
}

# find_cache: name a place for what outlives this workspace.
find_cache() {
    for CACHE in "${CACHES[@]}" "$WORKSPACE"; do
        ! is_ours "$CACHE" || return 0
    done
}

# need_write: end with one line if the set-up would end with `permission denied`.
need_write() {
    local thing
    for thing in "$CHECKOUT" "$CHECKOUT"/.ws{,/src,/lock,/setup.log} "$CHECKOUT/.venv"; do
        [ ! -e "$thing" ] || [ -w "$thing" ] ||
            fail "you cannot write to $thing, which belongs to $(stat -c %U "$thing"): clone the \
project into a folder of your own"
    done
}

# need_space: end with one line if the first set-up would fill the disk.
need_space() {
    local system=0 here=0
    has_parts "${PARTS[@]}" || system=1100
    python_is_ready || here=500
    if [ "$(stat -c %d "$USR")" = "$(stat -c %d "$CHECKOUT")" ]; then
        need_free "$CHECKOUT" $((system + here))
    else
        need_free "$USR" $system
        need_free "$CHECKOUT" $here
    fi
}

# need_free FOLDER MEGABYTES
need_free() {
    local free
    free=$(df -Pm "$1" | awk 'NR == 2 { print $4 }')
    [ "$free" -ge "$2" ] || fail "this needs $2 MB on the disk of $1, where $free MB are free"
}

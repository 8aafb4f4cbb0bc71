# PyBullet where PyPI has no wheel of it: compiled once, and kept for every later workspace.

# has_pybullet_wheel: whether PyPI has one for this Python, as of the version in requirements.txt.
has_pybullet_wheel() {
    case "$(python_version) $(uname -m)" in
        '3.8 x86_64' | '3.9 x86_64' | '3.10 x86_64' | '3.11 x86_64') ;;
        *) return 1 ;;
    esac
}

python_version() {
    /usr/bin/python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])'
}

# need_pybullet: where pip would not find a wheel of it, have one in the folder WHEELS.
need_pybullet() {
    local tag
    ! has_pybullet_wheel || return 0
    find_cache
    WHEELS=$CACHE/wheels
    tag=cp$(python_version | tr -d .)
    ! compgen -G "$WHEELS/$(pybullet | sed s/==/-/)-$tag-*_$(uname -m).whl" >/dev/null || return 0
    need_parts python3-dev
    announce "PyPI has no PyBullet for Python $(python_version) on $(uname -m). Compiling it takes \
about 5 minutes on two processors, this once: it is kept in $WHEELS"
    run_step 'compiling PyBullet' compile_pybullet "$WHEELS"
}

# compile_pybullet FOLDER: make a wheel of it there.
compile_pybullet() {
    local made_in=$WORKSPACE/compile
    rm -rf "$made_in"
    /usr/bin/python3 -m venv "$made_in/python"
    # Debugging symbols would double the time. /tmp may be small; an interruption ends all compilers.
    CFLAGS="${CFLAGS:-} -g0" TMPDIR=$made_in setsid "$made_in/python/bin/python3" -m pip wheel \
        --disable-pip-version-check --no-deps --wheel-dir "$1" "$(pybullet)" &
    trap "kill -- -$!" TERM
    wait $!
    rm -rf "$made_in"
}

pybullet() {
    grep -o '^pybullet==[0-9.]*' "$ROOT/requirements.txt"
}

# PyBullet where PyPI has no wheel of it: compiled once, and kept for every later workspace.

# has_pybullet_wheel: whether PyPI has one for this Python, as of the version in requirements.txt.
has_pybullet_wheel() {
    case "$(python_version) $(uname -m)" in
        '3.8 x86_64' | '3.9 x86_64' | '3.10 x86_64' | '3.11 x86_64') ;;
        *) return 1 ;;
    esac
}

python_version() {
    "$PYTHON" -c 'import sys; print("%d.%d" % sys.version_info[:2])'
}

pybullet() {
    grep -o '^pybullet==[0-9.]*' "$ROOT/requirements.txt"
}

# is_kept: whether there is one in the folder WHEELS, which this names.
is_kept() {
    find_cache
    WHEELS=$CACHE/wheels
    compgen -G "$WHEELS/$(pybullet | sed s/==/-/)-cp$(python_version | tr -d .)-*_$(uname -m).whl" \
        >/dev/null
}

# need_pybullet: where pip would not find a wheel of it, have one in the folder WHEELS.
need_pybullet() {
    ! has_pybullet_wheel && ! is_kept || return 0
    ! is_debians || need_parts "${COMPILER_PARTS[@]}"
    need_free "$WORKSPACE" 1000
    announce "PyPI has no PyBullet for Python $(python_version) on $(uname -m). Compiling it takes \
about 5 minutes on two processors, this once: it is kept in $WHEELS"
    run_step 'compiling PyBullet' compile_pybullet
}

compile_pybullet() {
    local made_in=$WORKSPACE/compile
    rm -rf "$made_in"
    "$PYTHON" -m venv "$made_in/python"
    # Debugging symbols would take a fifth of the time, and /tmp may be small. In a session of its
    # own all compilers end together. Without --use-pep517 pip wants the package wheel, which Python
    # 3.11's virtual environments lack. For arm64, GCC fuses multiplications with additions unless told
    # not to: the last digits would differ from those of the wheels for x86-64.
    CFLAGS="${CFLAGS:-} -g0 -ffp-contract=off" TMPDIR=$made_in setsid "$made_in/python/bin/python3" -m pip wheel \
        --disable-pip-version-check --no-cache-dir --no-deps --use-pep517 --wheel-dir "$WHEELS" "$(pybullet)" &
    trap "kill -- -$!" TERM
    wait $!
    rm -rf "$made_in"
}

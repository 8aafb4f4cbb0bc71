#!/usr/bin/env bash
# Follow docs/workspace.md literally: bash test/tools/own_workspace.sh REPOSITORY
#
# For a system with nothing on it, such as a new container: the page's commands install packages and
# write into the home. REPOSITORY is what the page has git clone.
set -euo pipefail

PAGE=$(dirname "$0")/../../docs/workspace.md
OUTPUT=$(mktemp -d)
LONGEST_DRIVE=120  # s; it takes 21
GOAL=2.0  # m
GOING_ON=()  # process groups

say() {
    echo "own_workspace: $1" >&2
}

fail() {
    say "$1"
    exit 1
}

# commands HEADING: print the first block that stands under it.
commands() {
    awk -v heading="## $1" -v repository="$REPOSITORY" '
        /^## / { here = $0 == heading }
        /^```/ { inside = !inside; blocks += here && inside; next }
        here && inside && blocks == 1 { gsub("REPOSITORY", repository); print }' "$PAGE"
}

# follow HEADING: type its commands one after the other, and say yes to apt.
follow() {
    say "$1"
    commands "$1" >"$OUTPUT/typed"
    [ -s "$OUTPUT/typed" ] || fail "the page has no commands under '$1'"
    cat "$OUTPUT/typed" >&2
    command -v sudo >/dev/null || sed -i 's/^sudo //' "$OUTPUT/typed"
    bash -e "$OUTPUT/typed" < <(yes) >"$OUTPUT/printed" 2>&1 && return
    tail -n 20 "$OUTPUT/printed" >&2
    fail "a command under '$1' has failed"
}

# in_terminal COMMAND: run it in a terminal of its own, which reads ~/.bashrc.
in_terminal() {
    # What a script leaves in the background ignores Ctrl-C.
    exec setsid env --default-signal=INT bash -ic "$1" </dev/null 2>&1
}

# leave_running HEADING: start each of its commands in a terminal.
leave_running() {
    local command
    say "$1"
    while read -r command; do
        echo "$command" >&2
        in_terminal "$command" >"$OUTPUT/terminal_${#GOING_ON[@]}" &
        GOING_ON+=($!)
    done < <(commands "$1")
}

# number FIELD: print what the next message has in it, or nothing.
number() {
    (in_terminal "timeout 10 rostopic echo -n1 $1") | grep -xE -- '-?[0-9][0-9.e-]*' || true
}

is_at_least() {
    awk -v seen="${1:-none}" -v goal="$2" 'BEGIN { exit !(seen != "none" && seen + 0 >= goal + 0) }'
}

# await_arrival: return once the detector counts two metres, and the robot is there.
await_arrival() {
    local start=$SECONDS
    until is_at_least "$(number /moved_distance/data)" $GOAL; do
        ((SECONDS - start < LONGEST_DRIVE)) || show_terminals
    done
    moved=$(number /moved_distance/data)
    place=$(number /base_pose_ground_truth/pose/pose/position/x)
    is_at_least "$place" $GOAL ||
        fail "the detector counts $moved m, but the robot is at '$place' m"
}

show_terminals() {
    tail -n 5 "$OUTPUT"/terminal_* >&2
    fail "the robot has not moved $GOAL m in $LONGEST_DRIVE s"
}

end_all() {
    local group
    for group in "${GOING_ON[@]}"; do
        kill -INT -- "-$group" 2>/dev/null || true
    done
    wait
    rm -rf "$OUTPUT"
}

main() {
    local folder
    [ $# = 1 ] || { sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2; }
    REPOSITORY=$1
    for folder in ~/catkin_ws ~/ros_python; do
        [ ! -e "$folder" ] ||
            fail "$folder is there already: this is for a system with nothing on it"
    done
    trap end_all EXIT
    follow 'What the packages need'
    follow 'Clone and build'
    say "ready to drive after $SECONDS s"
    ! { : </dev/tcp/localhost/11311; } 2>/dev/null || fail 'a ROS master runs here already'
    leave_running 'Drive in that workspace'
    await_arrival
    say "moved $moved m, is at x $place m, after $SECONDS s"
}

main "$@"

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# stages.sh, sourced: runs the stages of a check one after the other and sums them up. It counts what a
# stage has read, for a stage that reads nothing finds nothing wrong, and has checked nothing.

passed=0 failed=0 skipped=0 summary="" skipped_tests="" slowest_tests=""

# How many tests or files a log says were read: the closing line of ctest, or "N files read".
count_in() {
    sed -nE 's/^[0-9]+% tests passed, [0-9]+ tests? failed out of ([0-9]+)$/\1/p; s/^([0-9]+) files read$/\1/p' "$1" | tail -n 1
}

# The tests that ctest did not run, as it lists them behind its results.
skipped_in() { sed -nE 's/^[[:space:]]+[0-9]+ - (.*) \((Skipped|Disabled)\)$/\1/p' "$1"; }

# The ten tests of a log of ctest that took longest, with their seconds. What googletest says of a parameter
# behind the name of its test is left out.
slowest_in() {
    local seconds name
    sed -nE 's|^ *[0-9]+/[0-9]+ +Test +#[0-9]+: (.*) \.+[ *]+[A-Z][^.]* +([0-9]+\.[0-9]+) sec$|\2 \1|p' "$1" |
        sort -k 1,1rn -k 2 | head -n 10 | while read -r seconds name; do
        printf '  %8.1f s  %s\n' "$seconds" "${name%% *# GetParam*}"
    done
}

# stage NAME UNIT COMMAND...: runs it, keeps its output under $logs, notes the verdict and the seconds.
# UNIT: what it counts, "tests" or "files", at least one; "-" if it counts nothing.
stage() {
    local name=$1 unit=$2 start=$SECONDS verdict=passed count="" names
    shift 2
    echo
    echo "== $name"
    "$@" 2>&1 | tee "$logs/$name.log"
    [ "${PIPESTATUS[0]}" -eq 0 ] || verdict=FAILED
    if [ "$unit" != - ]; then
        count=$(count_in "$logs/$name.log")
        if [ "${count:-0}" -eq 0 ]; then
            echo "$name: no $unit were read"
            verdict=FAILED
        fi
        count="${count:-0} $unit"
        names=$(skipped_in "$logs/$name.log")
        if [ -n "$names" ]; then
            skipped=$((skipped + $(wc -l <<<"$names")))
            skipped_tests+=$(sed "s/^/  $name: /" <<<"$names")$'\n'
        fi
        names=$(slowest_in "$logs/$name.log")
        [ -z "$names" ] || slowest_tests+="slowest of $name:"$'\n'$names$'\n'
    fi
    if [ $verdict = passed ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    summary+=$(printf '%-24s%-8s%6d s  %s' "$name" $verdict $((SECONDS - start)) "$count")$'\n'
}

# Prints the verdicts; fails if a stage has failed.
sum_up() {
    echo
    echo "================================================================================"
    printf '%s' "$summary"
    printf '%s' "$slowest_tests"
    [ $skipped -eq 0 ] || printf '%d skipped tests:\n%s' $skipped "$skipped_tests"
    echo "logs: $logs/, time: $((SECONDS / 60)) min"
    echo "$passed passed, $failed failed"
    [ $failed -eq 0 ]
}

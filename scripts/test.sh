#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds with g++ and, under sanitizers, with clang, runs every test, checks
# format, lint and generated files. Every stage is run even if one before it failed.
set -uo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8
logs=build/logs
mkdir -p $logs

passed=0 failed=0 summary=""

# stage NAME COMMAND...: runs it, shows and keeps its output, notes the verdict and the seconds.
stage() {
    local name=$1 start=$SECONDS verdict=passed
    shift
    echo
    echo "== $name"
    "$@" 2>&1 | tee "$logs/$name.log"
    [ "${PIPESTATUS[0]}" -eq 0 ] || verdict=FAILED
    if [ $verdict = passed ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    summary+=$(printf '%-24s%-8s%6d s  %s' "$name" $verdict $((SECONDS - start)) \
        "$(grep -E '^[0-9]+% tests passed' "$logs/$name.log" || true)")$'\n'
}

build() { cmake --preset "$1" -DRESONFORM_TESTS=ON && cmake --build --preset "$1"; }
sanitized() {
    if [ ! -r /proc/self/maps ]; then # as in a chroot where nobody mounted /proc
        echo "SKIPPED: the sanitizers read /proc, which is not mounted here"
        return
    fi
    ctest --preset clang
}
sources() { find engine tests -name '*.cpp' -o -name '*.hpp' | LC_ALL=C sort; }
formatted() { sources | xargs clang-format-14 --dry-run --Werror; }
# The files of the engine as the clang build joins them: what they all include is read once.
linted() {
    find build/clang/CMakeFiles -name '*.cxx' -path '*/Unity/*' | LC_ALL=C sort |
        xargs -P 2 -n 1 clang-tidy-14 -p build/clang --quiet --warnings-as-errors='*'
}

if ! scripts/install_packages.sh scripts/packages_demo.txt scripts/packages_test.txt; then
    echo "0 passed, 1 failed: the packages could not be installed"
    exit 1
fi

stage release-build build release
stage release-tests ctest --preset release
stage generated build/release/resonform regenerate --check
stage clang-build build clang
stage clang-tests sanitized
stage format formatted
stage lint linted

echo
echo "================================================================================"
printf '%s' "$summary"
echo "logs: $logs/, time: $((SECONDS / 60)) min"
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]

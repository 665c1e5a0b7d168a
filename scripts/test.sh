#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds with g++ and, under sanitizers, with clang, runs every test, checks
# format, lint and generated files. Every stage is run even if one before it failed.
set -uo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8
logs=build/logs
mkdir -p $logs
. scripts/stages.sh

build() { cmake --preset "$1" -DRESONFORM_TESTS=ON && cmake --build --preset "$1"; }
tested() { ctest --preset "$1" --no-tests=error; }
sanitized() {
    if [ ! -r /proc/self/maps ]; then # as in a chroot where nobody mounted /proc
        echo "the sanitizers read /proc, which is not mounted here: mount -t proc proc /proc"
        return 1
    fi
    tested clang
}
# for_each_file COUNT COMMAND...: hands the files listed on standard input to the command, COUNT at a time, and
# says how many they were.
for_each_file() {
    local files
    files=$(LC_ALL=C sort)
    [ -n "$files" ] || return 1
    xargs -P 2 -n "$@" <<<"$files" || return 1
    echo "$(wc -l <<<"$files") files read"
}
generated() {
    build/release/resonform regenerate --check || return 1
    echo "$(find generated -name '*.hpp' | wc -l) files read"
}
formatted() { find engine tests -name '*.cpp' -o -name '*.hpp' | for_each_file 32 clang-format-14 --dry-run --Werror; }
# The files of the engine as the clang build joins them: what they all include is read once.
linted() {
    { find build/clang/CMakeFiles -name '*.cxx' -path '*/Unity/*'; echo engine/verify/sweep/hdf5.cpp; } |
        for_each_file 1 clang-tidy-14 -p build/clang --quiet --warnings-as-errors='*'
}

if ! scripts/install_packages.sh scripts/packages_demo.txt scripts/packages_test.txt; then
    echo "0 passed, 1 failed: the packages could not be installed"
    exit 1
fi

stage release-build - build release
stage release-tests tests tested release
stage generated files generated
stage clang-build - build clang
stage clang-tests tests sanitized
stage format files formatted
stage lint files linted

sum_up

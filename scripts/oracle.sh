#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# oracle.sh COMMIT: is what a user sees the same as at COMMIT? For changes of the house, which move and merge
# code and must not change a result. Builds COMMIT under build/oracle (kept for the next time), records
# there and here
#
#   tests     the names of all tests
#   headers   what is generated for every scene
#   derive    every stage and format of `derive` for every system, messages and exit codes included
#   messages  every message, with its exit code, that the tests of wrong input call forth
#
# and prints what differs; exit code 1 if anything does. New tests are listed and no difference; wordings that
# changed on purpose stand in tests/oracle/wording.sed.
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8

if [ $# -ne 1 ] || ! commit=$(git rev-parse --verify --quiet "$1^{commit}"); then
    echo "usage: scripts/oracle.sh COMMIT" >&2
    exit 2
fi
here=$PWD oracle=$PWD/build/oracle
before=$oracle/$commit

build() { (cd "$1" && cmake --preset release -DRESONFORM_TESTS=ON && cmake --build --preset release) >"$oracle/build.log" 2>&1; }

# derive_all TREE OUT: a file for each system, stage and format.
derive_all() {
    local tree=$1 out=$2 stages formats
    mkdir -p "$out"
    stages="constraints accelerations equations expand normal_form divisors manifold solution transgression"
    formats="text latex json sympy maxima"
    export tree out
    for system in "$tree"/systems/*/; do
        for stage in $stages; do
            for format in $formats; do echo "$(basename "$system") $stage $format"; done
        done
    done | xargs -P 2 -L 1 bash -c '
        cd "$tree"
        code=0
        build/release/resonform derive "$0" --order 3 --stage "$1" --format "$2" >"$out/$0.$1.$2" 2>&1 || code=$?
        echo "exit code $code" >>"$out/$0.$1.$2"'
}

# messages TREE FILE: of the tests of files, command lines and refusals; sorted, each once.
messages() {
    local tree=$1 file=$2 test
    : >"$file.all"
    for test in model expand solve emit cli; do
        (cd "$tree/build/release/tests" && RESONFORM_ERRORS=$file.all LD_PRELOAD=$here/build/release/tests/librecord_errors.so \
            ./test_$test --gtest_filter='-Slow*' >"$file.$test.log" 2>&1) || {
            echo "test_$test of $tree fails: $file.$test.log" >&2
            exit 1
        }
    done
    if [ ! -s "$file.all" ]; then
        echo "no message was recorded in $tree" >&2
        exit 1
    fi
    # Folders of a test run have names of their own.
    sed -E -e "s#$tree/#TREE/#g" -e 's#[^ ]*/resonform-test-[A-Za-z0-9]{6}#SCRATCH#g' "$file.all" | sort -u >"$file"
}

record() {
    local tree=$1 out=$2
    rm -rf "$out" "$out".work
    mkdir -p "$out" "$out".work
    ctest --test-dir "$tree/build/release" -N | sed -nE 's/^ +Test +#[0-9]+: //p' | sort >"$out/tests"
    cp -r "$tree/generated" "$out/headers"
    (cd "$tree" && build/release/resonform regenerate --check) >"$out/regenerate" 2>&1 || true
    derive_all "$tree" "$out/derive"
    messages "$tree" "$out.work/messages"
    mv "$out.work/messages" "$out/messages"
}

mkdir -p "$oracle"
if [ ! -d "$before" ]; then
    rm -rf "$before.part"
    mkdir "$before.part"
    git archive "$commit" | tar -x -C "$before.part"
    mv "$before.part" "$before"
fi
for tree in "$before" "$here"; do
    echo "== build: $tree"
    build "$tree" || { tail -n 20 "$oracle/build.log" >&2; exit 1; }
done
for side in before now; do
    echo "== record: $side"
    [ $side = now ] && tree=$here || tree=$before
    record "$tree" "$oracle/$side"
done

# Wordings that changed on purpose.
find "$oracle"/before/derive "$oracle"/before/messages -type f -exec sed -E -i -f tests/oracle/wording.sed {} +
sort -u -o "$oracle/before/messages" "$oracle/before/messages"

added=$(comm -13 "$oracle"/{before,now}/tests)
lost=$(comm -23 "$oracle"/{before,now}/tests)
echo "== $(wc -l <"$oracle/before/tests") tests before, $(wc -l <"$oracle/now/tests") now"
[ -z "$added" ] || echo "$added" | sed 's/^/new: /'
verdict=0
if [ -n "$lost" ]; then
    echo "$lost" | sed 's/^/lost: /'
    verdict=1
fi
diff -r --exclude=tests "$oracle/before" "$oracle/now" || verdict=1
[ $verdict -ne 0 ] || echo "the same: $(find "$oracle/now/headers" -type f | wc -l) headers, \
$(find "$oracle/now/derive" -type f | wc -l) answers of derive, $(wc -l <"$oracle/now/messages") messages"
exit $verdict

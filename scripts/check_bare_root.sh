#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_bare_root.sh [demo|test]...: runs the two commands of the README, or the one that is named, to their
# end, each in a Debian 12 of its own that has nothing but the minimal packages. Takes root, debootstrap and
# about an hour; to be run after every change of the lists of packages or of the CMake presets.
#
#   $RESONFORM_BARE_ROOT  the folder of the roots, default build/bare_root: made anew, removed if all went well;
#                         a folder that holds anything must be one that this script has made
#   $RESONFORM_MIRROR     the Debian mirror of debootstrap, default: that of this machine's apt
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8

commands=("$@")
[ ${#commands[@]} -gt 0 ] || commands=(demo test)
for command in "${commands[@]}"; do
    case $command in
    demo | test) ;;
    *)
        echo "usage: scripts/check_bare_root.sh [demo|test]..." >&2
        exit 2
        ;;
    esac
done

# The folder will be removed with all that is in it.
roots=$(realpath -m "${RESONFORM_BARE_ROOT:-build/bare_root}")
marker=.resonform_bare_root
refuse() {
    echo "check_bare_root.sh: RESONFORM_BARE_ROOT: $1" >&2
    echo "  found: $roots" >&2
    echo "  hint:  $2" >&2
    exit 2
}
above=${roots%/} # "" of /
for kept in "$(pwd -P)" "$(realpath -m "${HOME:-/}")"; do
    case "$kept/" in
    "$above"/*) refuse "the folder, which is removed, must not hold $kept" "give a folder of its own" ;;
    esac
done
if [ -e "$roots" ] && [ ! -e "$roots/$marker" ] && { [ ! -d "$roots" ] || [ -n "$(ls -A "$roots")" ]; }; then
    refuse "the folder, which is removed, must be empty or made by this script, with a file $marker" \
        "give another folder, or delete this one yourself"
fi

if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
    echo "check_bare_root.sh takes root and the package debootstrap" >&2
    exit 2
fi

mirror=${RESONFORM_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -n 1)}

unmount() {
    local root
    for root in "$roots"/*/; do
        if mountpoint -q "${root}proc"; then umount "${root}proc"; fi
    done
}
trap unmount EXIT
unmount
rm -rf "$roots"
mkdir -p "$roots"
touch "$roots/$marker"

echo "== the minimal packages: $roots"
debootstrap --variant=minbase bookworm "$roots/minbase" "$mirror"
# Where packages come from belongs to the machine, not to the project.
rm -f "$roots/minbase/etc/apt/sources.list"
for source in sources.list sources.list.d apt.conf.d; do
    [ ! -e /etc/apt/$source ] || cp -a /etc/apt/$source "$roots/minbase/etc/apt/"
done
cp -L /etc/resolv.conf /etc/hosts "$roots/minbase/etc/"

verdict=0 summary=""
for command in "${commands[@]}"; do
    # A root for each: neither command finds what the other has installed.
    root=$roots/$command start=$SECONDS code=0
    cp -a "$roots/minbase" "$root"
    mount -t proc proc "$root/proc"
    mkdir "$root/resonform"
    tar -c --exclude=./build --exclude=./.git . | tar -x -C "$root/resonform"
    echo "== scripts/$command.sh in the bare root"
    chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        "/resonform/scripts/$command.sh" || code=$?
    [ $code -eq 0 ] || verdict=1
    summary+="scripts/$command.sh: exit code $code, $(((SECONDS - start) / 60)) min"$'\n'
done
unmount
printf '%s' "$summary"
[ $verdict -ne 0 ] || rm -rf "$roots"
exit $verdict

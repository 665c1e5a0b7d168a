#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install_packages.sh LIST...: installs the Debian packages named in the lists, those that are missing.
# When all are present it does nothing and touches no network.
set -euo pipefail
export LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive

present() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

missing=()
for package in $(sed -e 's/#.*//' "$@"); do
    present "$package" || missing+=("$package")
done

if [ ${#missing[@]} -eq 0 ]; then
    echo "== packages: all present"
    exit 0
fi

if [ "$(id -u)" -eq 0 ]; then
    as_root=()
elif command -v sudo >/dev/null; then
    as_root=(sudo env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8)
else
    echo "These Debian packages are missing: ${missing[*]}" >&2
    echo "Installing them takes root or sudo; run as root:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
fi

echo "== packages: installing ${missing[*]}"
"${as_root[@]}" apt-get update
"${as_root[@]}" apt-get install --yes --no-install-recommends "${missing[@]}"

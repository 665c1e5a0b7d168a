#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# draw_rooms.sh: which room of engine/ includes which, as the drawing of docs/architecture.md (Mermaid): an
# arrow from a room to each room that it includes, but to those that it reaches through another one.
set -euo pipefail
cd "$(dirname "$0")/../engine"
export LC_ALL=C.UTF-8

grep -rhoH '^#include "[^"]*"' --include='*.?pp' . | sed -e 's|^\./||' -e 's|:#include "| |' -e 's|"$||' |
    awk '
    function room(path) { sub(/\/[^\/]*$/, "", path); sub(/^runtime\/.*/, "runtime", path); return path }
    { from = room($1); to = room($2); if (to !~ /\./ && from != to) { arrow[from, to] = 1; rooms[from]; rooms[to] } }
    END {
        for (a in rooms) for (b in rooms) reach[a, b] = (a, b) in arrow
        for (m in rooms) for (a in rooms) if (reach[a, m]) for (b in rooms) if (reach[m, b]) reach[a, b] = 1
        for (a in rooms) for (b in rooms) {
            if (!((a, b) in arrow)) continue
            direct = 1
            for (m in rooms) if (m != a && m != b && (a, m) in arrow && reach[m, b]) direct = 0
            if (direct) print "    " a " --> " b
        }
    }' | sort | sed '1i flowchart TD'

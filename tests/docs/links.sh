#!/usr/bin/env bash
# links.sh FOLDER: whether the links of all documents in it lead to files that are there, and to headings that they have.
set -euo pipefail
cd "$1"
visible=(find . -name build -prune -o -name '.?*' -prune -o)
mapfile -t documents < <("${visible[@]}" -name '*.md' -print)

awk '
    # a/./b/../c is a/c.
    function plain(path,    part, n, i, kept, depth) {
        n = split(path, part, "/")
        depth = 0
        for (i = 1; i <= n; ++i)
            if (part[i] == "..") --depth
            else if (part[i] != "." && part[i] != "") kept[++depth] = part[i]
        path = ""
        for (i = 1; i <= depth; ++i) path = path "/" kept[i]
        return path
    }
    FILENAME == "-" { exists[plain($0)]; next }
    FNR == 1 { code = 0 }
    /^```/ { code = !code }
    code { next }
    /^#+ / { # as anchors are made on the web
        heading = tolower($0)
        sub(/^#+ /, "", heading)
        gsub(/[^a-z0-9 _-]/, "", heading)
        gsub(/ /, "-", heading)
        anchor[plain(FILENAME) "#" heading]
    }
    {
        while (match($0, /\]\([^) ]+\)/)) {
            target = substr($0, RSTART + 2, RLENGTH - 3)
            $0 = substr($0, RSTART + RLENGTH)
            if (target ~ /^[a-z]+:/) continue
            path = target
            sub(/#.*/, "", path)
            folder = FILENAME
            sub(/[^\/]*$/, "", folder)
            path = path == "" ? plain(FILENAME) : plain(folder path)
            link[++links] = FILENAME ": " target
            to[links] = path
            if (target ~ /#/) place[links] = path substr(target, index(target, "#"))
        }
    }
    END {
        for (i = 1; i <= links; ++i)
            if (!(to[i] in exists)) { print link[i] ": there is no such file"; failed = 1 }
            else if (i in place && !(place[i] in anchor)) { print link[i] ": it has no such heading"; failed = 1 }
        print links " links" (failed ? "" : ", all good")
        exit failed
    }
' - "${documents[@]}" < <("${visible[@]}" -print)

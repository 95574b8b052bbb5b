#!/usr/bin/env bash
# Whether examples/README.md lists programs that there are, with the commands that their sources begin with, and forgets
# none; nor tools/README.md.
set -euo pipefail
cd "$(dirname "$0")/../../examples"

failed=
wrong() { echo "examples/README.md: $*" >&2 && failed=yes; }

# Each row: | idea | [file](path) | `command` |. The first table is that of the small programs.
rows=$(awk '/^## /{ ++part } part == 1 && /^\| .*\]\(.*\.cpp\)/' README.md)
[ -n "$rows" ] || wrong "no table"
while IFS='|' read -r _ idea file command _; do
    path=${file##*](} path=${path%)*}
    command=${command#*\`} command=${command%\`*}
    [ -f "$path" ] || { wrong "there is no $path" && continue; }
    name=$(basename "$path" .cpp)
    program=${command%% *}
    lines=$(wc -l <"$path")
    [ "$lines" -lt 100 ] || wrong "$path has $lines lines, too many for one idea"
    grep -qF "//     $command" < <(sed '/^\/\//!q' "$path") || wrong "$path does not begin with its command: $command"
    [ "${program#docs_}" = "$name" ] || wrong "the command of$idea is not that of $path"
    grep -qw "$name" "$(dirname "$path")/CMakeLists.txt" || wrong "$path is not built"
done <<<"$rows"

for path in small/*.cpp *.cpp; do
    grep -qF "]($path)" README.md || wrong "$path is not in it"
done
for path in ../tools/*.cpp ../tools/*/; do
    path=${path#../tools/}
    grep -qF "](${path%/})" ../tools/README.md || wrong "${path%/} is not in tools/README.md"
done
[ -z "$failed" ]

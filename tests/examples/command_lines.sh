#!/usr/bin/env bash
# command_lines.sh VERSION PROGRAM...: whether each program explains itself, says its version and refuses what it does not
# know.
set -uo pipefail
version=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

failed=
expect() { # CODE COMMAND...
    timeout 10 "${@:2}" >"$work/out" 2>"$work/err" </dev/null
    local got=$?
    [ "$got" -eq "$1" ] || wrong "exit code $got, expected $1: ${*:2}"
}
wrong() { echo "$*" && cat "$work/out" "$work/err" && failed=yes; }

for program in "$@"; do
    name=${program##*/}
    expect 0 "$program" --version
    [ "$(cat "$work/out")" = "$name (JausCat) $version" ] || wrong "$name --version says another"
    expect 0 "$program" --help
    head -1 "$work/out" | grep -q "^$name: " || wrong "$name --help does not begin with the name"
    cp "$work/out" "$work/help"
    expect 0 "$program" -h
    cmp -s "$work/help" "$work/out" || wrong "$name -h is not $name --help"
    grep -q '^  --version ' "$work/out" || wrong "$name --help does not list --version"
    expect 2 "$program" --nonsense
    grep -qFx "Try '$name --help'." "$work/err" || wrong "$name --nonsense does not say what to try"
    for option in --listen --ethercat-port --station; do
        grep -q -- "^  $option arg" "$work/help" || continue
        expect 2 "$program" "$option" 65536
        grep -q -- "$option must be 0 to 65535" "$work/err" || wrong "$name $option 65536: no range"
    done
    [ "$name" = cyclic ] || continue
    expect 2 "$program" --period -1
    grep -q -- "--period must not be negative" "$work/err" || wrong "a negative number is not refused as such"
    expect 2 "$program" --priority 100
done
for script in "$(dirname "$0")"/../../scripts/*; do
    grep -q -e --help "$script" || continue
    expect 0 "$script" --help
    cp "$work/out" "$work/help"
    expect 0 "$script" -h
    cmp -s "$work/help" "$work/out" || wrong "$script -h is not $script --help"
done
[ -z "$failed" ]

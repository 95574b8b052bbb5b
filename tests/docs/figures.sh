#!/usr/bin/env bash
# figures.sh FOLDER: whether the measured figures in its README.md are those of docs/performance.md.
set -euo pipefail
cd "$1"
rows=0
while read -r row; do
    rows=$((rows + 1))
    name=${row%%|*}
    grep -qF "| $row" docs/performance.md || {
        echo "README.md has: | $row"
        echo "docs/performance.md has: $(grep -F "| $name" docs/performance.md)"
        failed=yes
    }
done < <(sed -n 's/^| \(.* = \*\*.*|\)$/\1/p' README.md)
median() { sed -n "s/^| $1 | [0-9]* | \([0-9.]*\) |.*/\1/p" docs/performance.md; }
flash=$(grep -oE '[0-9.]+ times the flash' docs/performance.md)
for row in \
    "| SDO download on a raw link, two frames (by hand) | $(median 'SDO download of 28 bytes') us ($(median 'the two frames of that download, by hand')) |" \
    "| firmware node on a Cortex-M3, -Os, next to one written by hand | $flash |"; do
    rows=$((rows + 1))
    grep -qFx "$row" README.md || {
        echo "docs/performance.md has, and README.md has not: $row"
        failed=yes
    }
done
echo "$rows rows"
[ $rows -gt 2 ] && [ -z "${failed:-}" ]

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
echo "$rows rows"
[ $rows -gt 0 ] && [ -z "${failed:-}" ]

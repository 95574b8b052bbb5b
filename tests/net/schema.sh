#!/usr/bin/env bash
# The schema accepts each file in good/ and the examples, and none in broken/: schema.sh XMLLINT SCHEMA FOLDER EXAMPLE...
set -uo pipefail
xmllint=$1
schema=$2
folder=$3
shift 3
failed=0
valid() { "$xmllint" --noout --schema "$schema" "$1" 2>&1; }

for file in "$folder"/good/*.xml "$@"; do
    said=$(valid "$file") || {
        echo "refused: $said"
        failed=1
    }
done
for file in "$folder"/broken/*.xml; do
    if valid "$file" >/dev/null; then
        echo "accepted: $file"
        failed=1
    fi
done
exit $failed

#!/usr/bin/env bash
# includes.sh REPOSITORY: whether each guide that shows parts of programs shows what they include first, and says what to
# link.
set -uo pipefail
cd "$1" || exit 1

failed=
wrong() { echo "$*" >&2 && failed=yes; }

for page in README.md docs/*.md; do
    grep -qE '^<!-- code: docs/code/[a-z_]+\.[ch]pp [a-z]+ -->' "$page" || continue
    first=$(grep -m1 -nE '^<!-- code: docs/code/[a-z_]+\.[ch]pp [a-z]+ -->' "$page")
    [[ $first == *" includes -->" ]] || wrong "$page:${first%%:*}: a part of a program before what it includes"
    grep -qE "\`jauscat::(jauscat|text|catalogue|esi|net)\`" "$page" || wrong "$page: does not say what to link"
done
[ -z "$failed" ]

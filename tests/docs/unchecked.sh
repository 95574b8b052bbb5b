#!/usr/bin/env bash
# unchecked.sh FOLDER: no program of its documents or examples takes the value of an optional without a look whether it
# has one. The values of program options, in examples/support, always have one.
set -euo pipefail
cd "$1"
! grep -rnE '[])a-z_]\.value\(\)' README.md docs examples --include='*.md' --include='*.cpp' --include='*.hpp' |
    grep -v '^examples/support/'

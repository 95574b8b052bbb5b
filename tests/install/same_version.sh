#!/usr/bin/env bash
# same_version.sh SOURCE VERSION: that all files of packages say the VERSION of include/jauscat/version.hpp.
set -euo pipefail
cd "$1"
failed=0
expect() { # FILE PATTERN: the first line of FILE that matches has the version in its group
    local found
    found=$(sed -nE "s/$2/\\1/p" "$1" | head -n 1)
    [ "$found" = "$version" ] || { echo "$1 says '$found' instead of $version" >&2 && failed=1; }
}
version=$2
expect CHANGELOG.md '^## ([0-9.]+).*'
expect debian/changelog '^jauscat \(([0-9.]+)\).*'
exit "$failed"

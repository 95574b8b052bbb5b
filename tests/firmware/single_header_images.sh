#!/usr/bin/env bash
# single_header_images.sh SOURCE WORK [CMAKE_OPTION...]: builds two images of examples/firmware, one for each core, in
# WORK/build with the header that scripts/amalgamate writes, and with nothing else of JausCat.
set -euo pipefail
source=$1 work=$2
shift 2
rm -rf "$work/source"
mkdir -p "$work/source"/{examples,cmake,include,schemas}
cp -r "$source/examples/firmware" "$work/source/examples/"
cp "$source/cmake/warnings.cmake" "$work/source/cmake/"
"$source/scripts/amalgamate" --output "$work/source/include/jauscat.hpp"
find "$work/source/examples" -name '*.[ch]pp' -exec sed -i -E 's|#include <jauscat/.*>|#include <jauscat.hpp>|' {} +
cmake -S "$work/source/examples/firmware" -B "$work/build" -G Ninja \
    --toolchain "$source/cmake/toolchains/arm-none-eabi.cmake" "$@"
cmake --build "$work/build" --target real_m3 raw_m0

#!/bin/sh
# build_images.sh SOURCE_DIR PRESET: build what tests run on a board; says something only if that fails.
set -eu
cd "$1"
[ -f "build/firmware/${2#firmware-}/build.ninja" ] || scripts/quietly cmake --preset "$2"
scripts/quietly cmake --build --preset "$2" --parallel 2 --target all test_images

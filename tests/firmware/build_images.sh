#!/bin/sh
# build_images.sh SOURCE_DIR BOARD: build what tests run on a board; says something only if that fails.
set -eu
cd "$1"
for level in Os O2; do
    preset=firmware-$2-$level
    [ -f "build/firmware/$2-$level/build.ninja" ] || scripts/quietly cmake --preset "$preset"
    scripts/quietly cmake --build --preset "$preset" --parallel 2
done
scripts/quietly cmake --build --preset "$preset" --parallel 2 --target test_images

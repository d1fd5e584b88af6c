#!/bin/sh
# test_stack_mark.sh SOURCE_DIR BOARD IMAGE: the stack that an image was seen to use, on its emulated board, is within
# the bound that stack_usage.py finds for it, and takes at least nine tenths of it.
set -eu
source=$1
board=$2
image=$3

used=$("$source/firmware/emulators/run" "$board" "$image" | awk '$1 == "stack" { print $2 + 0 }')
line=$("$source/firmware/scripts/stack_usage.py" "$image.json" measure)
bound=$(echo "$line" | sed -n 's/^measure \([0-9]*\):.*/\1/p')
echo "used $used of $line"
[ "$used" -le "$bound" ] && [ $((10 * used)) -ge $((9 * bound)) ]

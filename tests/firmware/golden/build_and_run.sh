#!/usr/bin/env bash
# build_and_run.sh SOURCES COMPILER OPTION...: compile the golden program with the libraries' sources in the repository
# SOURCES, for this machine, and run it.
set -euo pipefail

sources=$1
compiler=$2
shift 2
command -v "$compiler" >/dev/null ||
    { echo "$compiler is not installed; scripts/install-deps installs it" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$compiler" -std=c99 -DTWD_NUMBER_FIXED "$@" -I"$sources"/controller/include -I"$sources"/learner/include \
    -I"$sources"/firmware/support "$sources"/controller/src/*.c "$sources"/learner/src/*.c \
    "$sources"/firmware/golden/*.c "$sources"/tests/firmware/host_board.c -o "$work"/golden
"$work"/golden

#!/usr/bin/env bash
# test_golden.sh GOLDEN LINE NAME COMMAND...: run the golden program by COMMAND, and hold what it writes to the file
# GOLDEN. Says so in one line, which it leaves in the file LINE, too; NAME is the machine and the compiler.
set -euo pipefail

golden=$1
line=$2
name=$3
shift 3

rm -f "$line"
expected=$(grep -v '^#' "$golden")
actual=$("$@") || { echo "FAILED: the golden program on $name ended with status $?; it wrote: $actual" >&2; exit 1; }
if [[ $actual != "$expected" ]]; then
    echo "FAILED: on $name the golden program writes '$actual', but $golden has '$expected'." >&2
    echo "If results are meant to change, and are the same on all machines, the new line belongs into that file." >&2
    exit 1
fi
mkdir -p "$(dirname "$line")"
printf '%-28s %s: equal\n' "$name" "$actual" | tee "$line"

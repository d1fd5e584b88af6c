#!/bin/sh
# test_stand_in.sh RUN BOARD IMAGE WITH_CMOCKA: the same tests of test_stand_in.c fail on a board, in the stand-in for
# cmocka, as with cmocka itself on the host, and both go on behind a failure.
set -eu
run=$1
board=$2
image=$3
with_cmocka=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

status=0
"$with_cmocka" >"$work/cmocka" 2>&1 || status=$?
[ $status -eq 12 ] || fail "with cmocka, $status tests failed"
status=0
"$run" "$board" "$image" >"$work/ours" 2>&1 || status=$?
[ $status -eq 1 ] || fail "exit status $status"

sed -n 's/^\[  FAILED  \] \([a-z_]*\)$/\1/p' "$work/cmocka" | sort -u >"$work/failed_with_cmocka"
tr -d '\r' <"$work/ours" | sed -n 's/^FAILED: //p' | sort >"$work/failed"
[ "$(wc -l <"$work/failed_with_cmocka")" -eq 12 ] || fail "cmocka's output was not expected: $(cat "$work/cmocka")"
diff "$work/failed_with_cmocka" "$work/failed" || fail 'other tests failed'

for sentence in 'number 0.250 of 12' 'the last test runs' 'test_stand_in.c:[0-9]*: the integers differ' \
    '12 tests failed'; do
    grep -q "$sentence" "$work/ours" || fail "it does not say '$sentence': $(cat "$work/ours")"
done
! grep -q 'behind the failure' "$work/ours" || fail 'a test went on behind its failure'

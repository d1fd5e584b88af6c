#!/usr/bin/env bash
# test_examples.sh SOURCE_DIR BOARD EXAMPLE HOST_PROGRAM: the image EXAMPLE of `make firmware`, at -Os and at -O2, says
# on BOARD what it says on this machine, where it is HOST_PROGRAM: fixed-point images to the letter, others within
# 0.002, as a chip may round another way.
set -euo pipefail

source=$1
board=$2
example=$3
host=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail()
{
    echo "FAILED: $1" >&2
    exit 1
}

# The same words, and numbers within 0.002; counts are numbers, too.
close()
{
    awk '
    NR == FNR { expected[FNR] = $0; lines = FNR; next }
    {
        count = split(expected[FNR], word)
        bad = bad || count != NF
        for (i = 1; i <= NF; i++) {
            both_numbers = $i ~ /^[+-]?[0-9.]+$/ && word[i] ~ /^[+-]?[0-9.]+$/
            distance = both_numbers ? $i - word[i] : ($i == word[i] ? 0 : 1)
            bad = bad || distance > 0.002 || distance < -0.002
        }
        read = FNR
    }
    END { exit bad || read != lines }' "$1" "$2"
}

"$host" >"$work/expected" || fail "on this machine it ends with status $?: $(<"$work/expected")"
[[ -s $work/expected ]] || fail 'it says nothing on this machine'
for level in Os O2; do
    image=$source/build/firmware/$board-$level/bin/$example
    [[ -r $image ]] || fail "there is no $image; make firmware builds it"
    "$source/firmware/emulators/run" "$board" "$image" >"$work/output" ||
        fail "at -$level it ends with status $?: $(<"$work/output")"
    compare=close
    [[ $example == *_fixed ]] && compare='cmp -s'
    $compare "$work/expected" "$work/output" || fail "at -$level it says
$(<"$work/output")
where this machine says
$(<"$work/expected")"
done

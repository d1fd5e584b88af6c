#!/usr/bin/env bash
# test_tutorial.sh SOURCE_DIR PROGRAM: the commands of docs/TUTORIAL.md, typed block after block in a copy of the
# folders that they name, with PROGRAM as the one that was built, do what the page says.
set -euo pipefail

source=$1
program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset TWIDDLE_MODELS # of the make that runs the tests

fail()
{
    echo "FAILED: $1" >&2
    exit 1
}

# commands_of PAGE: its blocks marked sh; an unfinished one is an error.
commands_of()
{
    awk '
    /^```sh$/ { inside = 1; next }
    /^```$/ { inside = 0; next }
    inside
    END { exit inside }' "$1"
}

# same_numbers FILE FILE: rows of comma-separated numbers that agree within half a unit of the ninth decimal.
same_numbers()
{
    paste -d, "$1" "$2" | awk -F, '
    NF != 8 { bad = 1 }
    { for (i = 1; i <= 4; i++) if ($i - $(i + 4) > 5.1e-10 || $i - $(i + 4) < -5.1e-10) bad = 1 }
    END { exit bad || NR != 300 }'
}

# mean_of_last RUN: of the rotations of its last trials, in rad.
mean_of_last()
{
    sed -n 's/.*"mean_rotation_of_last_rad": \([0-9.e-]*\).*/\1/p' "$1/run.json"
}

copy=$work/copy
mkdir -p "$copy/build/host/bin"
cp -r "$source"/{controller,learner,plots,models,experiments} "$copy"
ln -s "$program" "$copy/build/host/bin/twiddle"

commands_of "$source/docs/TUTORIAL.md" >"$work/commands" || fail 'a block does not end'
(cd "$copy" && bash -euo pipefail "$work/commands") >"$work/output" 2>&1 ||
    fail "the commands end with status $?: $(tail -n 20 "$work/output")"

results=$copy/results/tutorial
for file in first/run.json first/replay.html first/figures/{learning_curve,selector_weights}.png \
    slippery/trajectory.csv friction.html cap.h; do
    [[ -s $results/$file ]] || fail "there is no $file"
done

# Setting, and what it does: Coulomb's law gives slippery fingers less to turn with.
changed=$(diff "$results/first/run.json" "$results/slippery/run.json" | grep -c '^> *"friction": 0.2,$') || true
[[ $changed == 1 ]] || fail 'the second run has another friction than 0.2'
awk -v first="$(mean_of_last "$results/first")" -v slippery="$(mean_of_last "$results/slippery")" \
    'BEGIN { exit !(slippery > 0 && slippery < first) }' || fail 'the slippery cap was turned as far as the other'

# The player shares no line with the simulation but the library.
grep -v '^[#s]' "$results/first/trajectory.csv" | cut -d, -f3,6,9,12 >"$work/recorded.csv"
same_numbers "$results/desired.csv" "$work/recorded.csv" ||
    fail 'the exported skill plays other angles than the replay has'

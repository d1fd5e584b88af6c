#!/bin/sh
# test_confirm_steppers.sh SOURCE_DIR PROGRAM CASE: one claim about scripts/confirm-steppers.
set -eu
source=$1
program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sweep="$work/a sweep"

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

confirm() {
    status=0
    TWIDDLE=$twiddle "$source/scripts/confirm-steppers" "$sweep" >"$work/out" 2>"$work/error" || status=$?
}

# A program whose reference turns the object by 0.3 rad more than its fast stepper, which turns it by the seed.
stand_in() {
    twiddle=$work/twiddle
    cat >"$twiddle" <<'END'
#!/bin/sh
# replay RUN --stepper STEPPER --out FILE
[ "$1$3$5" = replay--stepper--out ] || exit 2
[ -e "$2/run.json" ] || { echo "twiddle: '$2' is no folder of a run" >&2; exit 2; }
more=0
[ "$4" = fast ] || more=0.3
printf '# stepper: %s\n# rotation_rad: %s\nstep,object_rad\n1,99\n' "$4" \
    "$(echo "${2##*-} $more" | awk '{ print $1 + $2 }')" >"$6"
END
    chmod +x "$twiddle"
}

make_run() { # OBJECT MODEL SEED
    mkdir -p "$sweep/$1/$2/seed-$3"
    echo '{}' >"$sweep/$1/$2/seed-$3/run.json"
}

case $3 in
prints_both_rotations_of_every_run_of_cpg_h)
    stand_in
    for seed in 10 2; do
        make_run large-cube cpg-h $seed
        make_run small-sphere cpg-h $seed
        make_run small-sphere cpg-c $seed
    done
    confirm
    [ "$status" -eq 0 ] || fail "$(cat "$work/error")"
    cat >"$work/expected" <<'END'
| object | seed | fast (rad) | reference (rad) |
| --- | --- | --- | --- |
| small-sphere | 2 | 2.000 | 2.300 |
| small-sphere | 10 | 10.000 | 10.300 |
| large-cube | 2 | 2.000 | 2.300 |
| large-cube | 10 | 10.000 | 10.300 |

4 runs: means 6.000 and 6.300 rad, root mean square difference 0.300 rad, largest 0.300 rad
END
    diff "$work/expected" "$work/out" || fail 'another table'
    ;;
takes_what_the_program_trains)
    twiddle=$program
    "$twiddle" train --object medium-sphere --model cpg-h --seed 1 --trials 200 \
        --out "$sweep/medium-sphere/cpg-h/seed-1" \
        >/dev/null 2>&1
    confirm
    [ "$status" -eq 0 ] || fail "$(cat "$work/error")"
    # The two agree on nearly all policies within 0.1 rad (docs/SIMULATION.md).
    awk -F ' *[|] *' '$2 == "medium-sphere" { off = $4 - $5; near = $4 > 0.5 && off < 0.1 && off > -0.1 }
        END { exit !near }' "$work/out" || fail "unlikely rotations: $(cat "$work/out")"
    ;;
refuses_an_incomplete_run)
    stand_in
    make_run small-sphere cpg-h 1
    mkdir "$sweep/small-sphere/cpg-h/seed-2"
    confirm
    [ "$status" -eq 1 ] || fail "exit status $status, expected 1"
    grep -q "seed-2' is no folder of a run" "$work/error" || fail "said: $(cat "$work/error")"
    [ ! -s "$work/out" ] || fail 'prints a table'
    ;;
refuses_a_folder_without_runs)
    stand_in
    confirm
    [ "$status" -eq 2 ] || fail "exit status $status, expected 2"
    grep -q "holds no run of cpg-h" "$work/error" || fail "said: $(cat "$work/error")"
    ;;
*) fail "no case $3" ;;
esac

#!/usr/bin/env bash
# test_run.sh RUN IMAGES BOARD CLAIM: one claim about firmware/emulators/run on one board. IMAGES/BOARD-O2/bin has the
# images of images/ (make firmware); TWIDDLE_EMULATORS our programs.
set -euo pipefail

run=$1
bin=$2/$3-O2/bin
board=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail()
{
    echo "FAILED: $1" >&2
    exit 1
}

[[ -r $bin/emulator_known_costs ]] || fail "there is no $bin/emulator_known_costs; make firmware builds it"

# run_it STATUS OPTION... IMAGE: run an image, or anything else, on the board; its output is then in `output` and
# `error`.
run_it()
{
    local wanted=$1 status=0
    shift
    "$run" "${@:1:$#-1}" "$board" "${@: -1}" >"$work/output" 2>"$work/error" </dev/null || status=$?
    output=$(<"$work/output")
    error=$(<"$work/error")
    [[ $status == "$wanted" ]] || fail "exit status $status, expected $wanted; it said: $output $error"
}

count_known_costs() # CSV
{
    run_it 42 --count loop_of_100 --count calls_it_twice --count loop_of --count never_called --counts "$1" \
        "$bin/emulator_known_costs"
}

# The costs by hand of images/known_costs.S: of calls_it_twice, of its own part of it, of loop_of_100, of loop_of(1), of
# loop_of(10), of the ten together.
case $board in
    atmega1284p) costs=(618 10 304 6 33 195) unit=cycles ;;
    virt) costs=(411 7 202 3 21 120) unit=instructions ;;
    *) costs=(408 4 202 3 21 120) unit=instructions ;;
esac

case $4 in
counts_what_functions_cost)
    count_known_costs "$work/counts.csv"
    cat >"$work/expected.csv" <<END
function,part,calls,total,least,most
loop_of_100,,3,$((3 * costs[2])),${costs[2]},${costs[2]}
loop_of_100,loop_of_100,,$((3 * costs[2])),,
calls_it_twice,,1,${costs[0]},${costs[0]},${costs[0]}
calls_it_twice,loop_of_100,,$((2 * costs[2])),,
calls_it_twice,calls_it_twice,,${costs[1]},,
loop_of,,10,${costs[5]},${costs[3]},${costs[4]}
loop_of,loop_of,,${costs[5]},,
never_called,,0,0,0,0
END
    # Parts come in the order of addresses, which is the linker's choice.
    sort "$work/expected.csv" >"$work/expected"
    grep -v '^#' "$work/counts.csv" | sort | diff "$work/expected" - >&2 || fail 'other counts than those by hand'
    grep -q "^# $unit " "$work/counts.csv" || fail "does not say that it counts $unit"
    ;;
counts_by_address)
    run_it 42 --by-address --count loop_of_100 --counts "$work/counts.csv" "$bin/emulator_known_costs"
    # Three calls: load, a hundred times decrement and branch, return.
    case $board in
        atmega1284p) expected='3 300 597 12' ;;
        *) expected='3 300 300 3' ;;
    esac
    got=$(grep '^loop_of_100,0x' "$work/counts.csv" | cut -d , -f 4 | paste -s -d ' ')
    [[ $got == "$expected" ]] || fail "costs of the four instructions: $got, expected $expected"
    ;;
counts_the_same_again)
    count_known_costs "$work/first.csv"
    count_known_costs "$work/second.csv"
    cmp "$work/first.csv" "$work/second.csv" >&2 || fail 'two runs differ'
    ;;
passes_on_output_and_status)
    run_it 42 "$bin/emulator_known_costs"
    [[ $output == 'called them all' && -z $error ]] || fail "said: $output $error"
    ;;
passes_on_arguments)
    "$run" "$board" "$bin/emulator_arguments" 'one,two' three >"$work/output" || fail "exit status $?"
    [[ $(<"$work/output") == "$bin/emulator_arguments one,two three" ]] || fail "command line: $(<"$work/output")"
    ;;
refuses_arguments)
    status=0
    "$run" "$board" "$bin/emulator_stops" one 2>"$work/error" || status=$?
    [[ $status == 2 && $(<"$work/error") == 'run: atmega1284p passes no arguments to its image' ]] ||
        fail "said: $(<"$work/error")"
    ;;
ends_a_hang_in_time)
    SECONDS=0
    run_it 124 --seconds 1 "$bin/emulator_hangs"
    ((SECONDS <= 6)) || fail "took $SECONDS s"
    [[ $output == 'going to hang' ]] || fail "lost its output: $output"
    [[ $error == *"did not end within 1 s on $board"* ]] || fail "said: $error"
    ;;
tells_a_crash)
    run_it 3 "$bin/emulator_crashes"
    [[ $output == 'going to crash'* ]] || fail "lost its output: $output"
    ;;
refuses_a_function_that_is_not_there)
    run_it 2 --count nothing "$bin/emulator_known_costs"
    [[ $error == *'the image has no function nothing to count' ]] || fail "said: $error"
    ;;
refuses_an_image_that_is_not_there)
    run_it 2 "$work/nowhere"
    [[ $error == "run: cannot read the image $work/nowhere" ]] || fail "said: $error"
    ;;
refuses_wrong_use)
    run_it 2 --seconds soon "$bin/emulator_known_costs"
    [[ $error == *"--seconds expects a whole number above 0, not 'soon'"* ]] || fail "said: $error"
    run_it 2 --loudly yes "$bin/emulator_known_costs"
    [[ $error == *'unknown option --loudly'* ]] || fail "said: $error"
    board=nucleo
    run_it 2 "$bin/emulator_known_costs"
    [[ $error == *'unknown board nucleo, expected one of: microbit, '* ]] || fail "said: $error"
    ;;
*) fail "no claim $4" ;;
esac

#!/usr/bin/env bash
# test_avr_run.sh AVR_RUN IMAGES CLAIM: one claim about avr_run beyond those of test_run.sh, with the images of images/.
set -euo pipefail

avr_run=$1
bin=$2/atmega1284p-O2/bin
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail()
{
    echo "FAILED: $1" >&2
    exit 1
}

# expect STATUS ERROR_PART ARGUMENT...: run it with those arguments.
expect()
{
    local wanted=$1 part=$2 status=0
    shift 2
    "$avr_run" "$@" >"$work/output" 2>"$work/error" || status=$?
    [[ $status == "$wanted" ]] || fail "exit status $status, expected $wanted; it said: $(<"$work/error")"
    [[ $(<"$work/error") == *"$part"* ]] || fail "no '$part' in: $(<"$work/error")"
}

case $3 in
ends_after_so_many_cycles)
    expect 3 'is not done after 1000000 cycles' --cycles 1000000 "$bin/emulator_hangs"
    ;;
ends_where_the_image_stopped_for_ever)
    expect 3 "$bin/emulator_stops stopped at address 0x" "$bin/emulator_stops"
    ;;
feeds_standard_input_to_the_uart)
    head -c 2000 /dev/zero | tr '\0' 'a' >"$work/line"
    echo b >>"$work/line"
    expect 0 '' --stdin "$bin/emulator_echo" <"$work/line"
    { printf 'echo: ' && tr a-z A-Z <"$work/line"; } | cmp - "$work/output" >&2 || fail 'the echo differs'
    ;;
refuses_what_is_no_image)
    echo text >"$work/text"
    expect 2 "$work/text is not an ELF file with a symbol table of functions" "$work/text"
    expect 2 "$avr_run is not an image for an AVR" "$avr_run"
    ;;
refuses_wrong_use)
    expect 2 'usage: avr_run'
    expect 2 "--cycles expects a whole number above 0, not '-5'" --cycles -5 "$bin/emulator_stops"
    expect 2 '--count and --out need each other' --count main "$bin/emulator_stops"
    ;;
*) fail "no claim $3" ;;
esac

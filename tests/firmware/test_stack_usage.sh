#!/bin/sh
# test_stack_usage.sh SOURCE_DIR CASE: one claim about firmware/scripts/stack_usage.py, on programs whose
# stack is known, for every instruction set.
set -eu
source=$1
claim=$2
programs=$source/tests/firmware/stack
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    echo "FAILED: $core: $1" >&2
    exit 1
}

cores='m0 m4 riscv avr'
of_core() { # sets `prefix` and `flags`
    case $core in
    m0) prefix=arm-none-eabi flags='-mcpu=cortex-m0plus -mthumb' ;;
    m4) prefix=arm-none-eabi flags='-mcpu=cortex-m4 -mthumb' ;;
    riscv) prefix=riscv64-unknown-elf flags='-march=rv32imac -mabi=ilp32 -ffreestanding' ;;
    avr) prefix=avr flags=-mmcu=atmega1284p ;;
    esac
}

# compile PROGRAM [FLAG...]: an image of $work/PROGRAM's object alone; libgcc may help.
compile() {
    program=$1
    shift
    rm -rf "$work/frames"
    mkdir "$work/frames"
    # shellcheck disable=SC2086 # flags are words
    "$prefix-gcc" $flags -O2 -std=c99 -fstack-usage -fno-inline "$@" -c "$programs/$program" -o "$work/frames/object.o"
    # shellcheck disable=SC2086
    "$prefix-gcc" $flags -nostdlib -Wl,-e,main "$work/frames/object.o" -lgcc -o "$work/image"
}

stack_usage() { # FUNCTION...
    "$source/firmware/scripts/stack_usage.py" --objdump "$prefix-objdump" --frames "$work/frames" "$work/image" "$@"
}

frame_of() { # FUNCTION: the compiler's word
    awk -F'[:\t]' -v name="$1" '$4 == name { print $5 }' "$work"/frames/*.su
}

# is FUNCTION BYTES
is() {
    printed=$(stack_usage "$1") || fail "$printed"
    [ "${printed%%:*}" = "$1 $2" ] || fail "expected $1 $2, got $printed"
}

# is_unknown FUNCTION REASON
is_unknown() {
    status=0
    printed=$(stack_usage "$1") || status=$?
    [ $status -eq 1 ] || fail "exit status $status for $1"
    [ "$printed" = "$1 unknown: $2" ] || fail "expected '$2', got $printed"
}

# refuses PATTERN COMMAND...
refuses() {
    pattern=$1
    shift
    status=0
    "$@" >"$work/out" 2>"$work/error" || status=$?
    [ $status -eq 1 ] || fail "exit status $status"
    [ "$(wc -l <"$work/error")" -eq 1 ] || fail "not one line: $(cat "$work/error")"
    grep -q -- "$pattern" "$work/error" || fail "'$pattern' is not in: $(cat "$work/error")"
}

run_claim() {
    case $claim in
    sums_the_frames_of_the_deepest_path)
        compile chain.c -fno-optimize-sibling-calls
        is main $(($(frame_of main) + $(frame_of deep) + $(frame_of deeper)))
        [ "$(frame_of deeper)" -ge 40 ] || fail 'the program has no such frames'
        ;;
    tail_call_gives_its_frame_back)
        compile tail.c
        [ "$(frame_of first)" -gt "$(frame_of second)" ] || fail 'the program is not what it says'
        expected=$(frame_of first)
        case $core in m0 | avr) # GCC makes a plain call of it there
            expected=$((expected + $(frame_of second))) ;;
        esac
        is first "$expected"
        is main $(($(frame_of main) + expected))
        ;;
    call_that_does_not_return_is_no_way_on)
        compile no_return.c -fno-toplevel-reorder
        is again $(($(frame_of again) + $(frame_of ends_with_stop) + $(frame_of stop)))
        ;;
    switch_is_no_call_through_a_pointer)
        compile choice.c
        is choose $(($(frame_of choose) + $(frame_of callee)))
        ;;
    says_why_there_is_no_bound)
        compile unbounded.c
        is_unknown through_a_pointer 'through_a_pointer calls through a pointer'
        is_unknown through_a_pointer_at_last 'through_a_pointer_at_last calls through a pointer'
        is_unknown variable 'variable has a frame of variable size'
        is_unknown caller 'ping calls itself, directly or through others'
        ;;
    follows_assembly_from_symbol_to_symbol)
        compile joined.S
        printf 'other.c:1:1:other\t0\tstatic\n' >"$work/frames/other.su"
        case $core in
        avr) is joined 7 && is main 9 ;;
        riscv) is joined 48 && is main 64 ;;
        *) is joined 20 && is main 28 ;;
        esac
        ;;
    refuses_what_it_cannot_read)
        compile chain.c
        refuses 'no function nowhere' stack_usage nowhere
        rm "$work"/frames/*.su
        refuses 'holds no .su files' stack_usage main
        ;;
    *) fail "no case $claim" ;;
    esac
}

for core in $cores; do
    of_core
    run_claim
done

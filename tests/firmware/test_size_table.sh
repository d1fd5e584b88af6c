#!/bin/sh
# test_size_table.sh SOURCE_DIR CASE: one claim about firmware/scripts on the images that `make firmware` builds.
set -eu
source=$1
images=$source/build/firmware
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

toolchain() { # BOARD
    case $1 in
    virt) echo riscv64-unknown-elf ;;
    atmega1284p) echo avr ;;
    *) echo arm-none-eabi ;;
    esac
}

# cell BOARD NUMBER COLUMN: of the table in $work/table
cell() {
    awk -F ' *[|] *' -v board="$1" -v number="$2" -v column="$3" '
        NR == 1 { for (i = 1; i <= NF; i++) place[$i] = i }
        $2 == board && $place["number"] == number { print $place[column] }' "$work/table"
}

case $2 in
sizes_are_binutils)
    boards='microbit mps2-an386 mps2-an500 virt atmega1284p'
    # shellcheck disable=SC2046 # one argument a board
    "$source/firmware/scripts/size_table.py" $(for board in $boards; do echo "$images/$board-O2"; done) >"$work/table"
    for board in $boards; do
        for number in float fixed; do
            case $number in float) image=control ;; *) image=control_$number ;; esac
            "$(toolchain "$board")-size" "$images/$board-O2/bin/$image" >"$work/size"
            flash=$(awk 'NR == 2 { print $1 + $2 }' "$work/size")
            ram=$(awk 'NR == 2 { print $2 + $3 }' "$work/size")
            [ "$(cell "$board" "$number" 'image flash')" = "$flash" ] ||
                fail "$board $number: flash is $flash, not as in $(cat "$work/table")"
            [ "$(cell "$board" "$number" 'image RAM')" = "$ram" ] ||
                fail "$board $number: RAM is $ram, not as in $(cat "$work/table")"
            stack=$(cell "$board" "$number" 'main stack')
            [ "$stack" -gt "$(cell "$board" "$number" 'tick stack')" ] || fail "$board $number: main stack $stack"
        done
    done
    ;;
disassembly_agrees_with_the_compiler)
    for board in microbit mps2-an386 virt; do
        for image in control control_fixed; do
            set -- twd_controller_tick twd_controller_torque twd_learner_act twd_learner_learn
            "$source/firmware/scripts/stack_usage.py" "$images/$board-O2/bin/$image.json" "$@" >"$work/with_frames"
            "$source/firmware/scripts/stack_usage.py" --objdump "$(toolchain $board)-objdump" \
                --frames "$images/$board-O2/firmware/CMakeFiles/board.dir" "$images/$board-O2/bin/$image" "$@" \
                >"$work/alone" || fail "$board $image: $(cat "$work/alone")"
            cut -d: -f1 "$work/with_frames" >"$work/expected"
            cut -d: -f1 "$work/alone" | diff "$work/expected" - || fail "$board $image: without the frames it differs"
        done
    done
    ;;
refuses_a_folder_without_images)
    status=0
    "$source/firmware/scripts/size_table.py" "$work" >"$work/out" 2>"$work/error" || status=$?
    [ $status -eq 1 ] || fail "exit status $status"
    grep -q "$work: holds no image control" "$work/error" || fail "$(cat "$work/error")"
    [ ! -s "$work/out" ] || fail 'printed a table of nothing'
    ;;
*) fail "no case $2" ;;
esac

#!/bin/sh
# test_draw_run.sh SOURCE_DIR SVG_CHECK CASE: one claim about plots/draw-run, on made-up runs.
set -eu
source=$1
svg_check=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run=$work/run
figures='learning_curve joint_angles fingertip_paths rotation_and_contact'

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

make_run() { # TRIALS MODEL
    mkdir -p "$run"
    awk -v folder="$run" -v trials="$1" -v model="$2" -f "$source/tests/plots/made_up_run.awk"
}

# Run draw-run; it must exit with STATUS, say one sentence that matches PATTERN, and leave no figures.
refuses() { # STATUS PATTERN ARGUMENT...
    expected=$1
    pattern=$2
    shift 2
    status=0
    "$source/plots/draw-run" "$@" >"$work/out" 2>"$work/error" || status=$?
    [ "$status" -eq "$expected" ] || fail "exit status $status, expected $expected: $(cat "$work/error")"
    [ "$(wc -l <"$work/error")" -eq 1 ] || fail "not one line: $(cat "$work/error")"
    grep -q -- "$pattern" "$work/error" || fail "'$pattern' is not in: $(cat "$work/error")"
    [ ! -s "$work/out" ] || fail 'printed paths of figures that were not drawn'
    [ ! -e "$run/figures" ] || fail "left $(ls -A "$run/figures") behind"
}

# All of $figures are there in both formats, are what they claim to be, are listed, and nothing else is there.
drawn_in() { # OUT_DIR
    for figure in $figures; do
        "$svg_check" "$1/$figure.svg" || fail "$figure.svg is not well-formed SVG"
        [ "$(dd if="$1/$figure.png" bs=1 skip=1 count=3 2>/dev/null)" = PNG ] || fail "$figure.png is not a PNG"
        # An empty canvas of these sizes compresses to under 10 kB; a figure with curves and labels does not.
        [ "$(wc -c <"$1/$figure.png")" -gt 20000 ] || fail "$figure.png looks empty"
    done
    for figure in $figures; do printf '%s\n' "$1/$figure.svg" "$1/$figure.png"; done | sort >"$work/expected"
    sort "$work/out" | cmp - "$work/expected" || fail "printed: $(cat "$work/out")"
    find "$1" -type f | sort | cmp - "$work/expected" || fail "drew: $(ls -A "$1")"
}

case $3 in
draws_all_figures_of_a_run_as_svg_and_png)
    make_run 300 cpg-h
    figures="$figures selector_weights"
    "$source/plots/draw-run" "$run" >"$work/out"
    drawn_in "$run/figures"
    ;;
draws_no_selector_for_a_lone_cpg)
    make_run 300 cpg-c
    "$source/plots/draw-run" "$run" >"$work/out"
    drawn_in "$run/figures"
    ;;
draws_a_run_shorter_than_the_running_mean)
    make_run 20 cpg-c
    "$source/plots/draw-run" "$run" >"$work/out"
    drawn_in "$run/figures"
    ;;
takes_any_folder_name)
    run="$work/it's \`a\` \$run %d \"x\""
    make_run 300 cpg-c
    "$source/plots/draw-run" "$run" "$work/o'ut dir" >"$work/out"
    drawn_in "$work/o'ut dir"
    ;;
refuses_a_missing_file)
    for file in run.json trials.csv trajectory.csv object_outline.csv; do
        make_run 20 cpg-h
        rm "$run/$file"
        refuses 2 "no readable $file" "$run"
    done
    refuses 2 'not a folder' "$work/nowhere"
    refuses 2 'usage'
    ;;
refuses_a_missing_column)
    make_run 20 cpg-h
    sed 's/object_rad/angle/' "$run/trajectory.csv" >"$work/other" && mv "$work/other" "$run/trajectory.csv"
    refuses 2 'trajectory.csv has no column object_rad' "$run"
    ;;
leaves_nothing_behind_when_gnuplot_fails)
    make_run 20 cpg-h
    sed '3,$d' "$run/trajectory.csv" >"$work/other" && mv "$work/other" "$run/trajectory.csv"
    refuses 1 'gnuplot could not draw' "$run"
    ;;
says_that_gnuplot_is_missing)
    make_run 20 cpg-h
    mkdir "$work/bin"
    ln -s "$(command -v sh)" "$work/bin/sh"
    status=0
    env PATH="$work/bin" "$work/bin/sh" "$source/plots/draw-run" "$run" 2>"$work/error" || status=$?
    [ "$status" -eq 1 ] || fail "exit status $status, expected 1"
    grep -q 'gnuplot is not installed' "$work/error" || fail "said: $(cat "$work/error")"
    [ ! -e "$run/figures" ] || fail 'left a folder behind'
    ;;
*) fail "no case $3" ;;
esac

#!/bin/sh
# test_draw_sweep.sh SOURCE_DIR SVG_CHECK CASE: one claim about plots/draw-sweep, on made-up sweeps.
set -eu
source=$1
svg_check=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sweep=$work/sweep
figures='fig5 fig6 fig7 fig8 table1 table2 contacts rotation'
all_objects='small-sphere small-cylinder small-cube medium-sphere medium-cylinder medium-cube'
all_objects="$all_objects large-sphere large-cylinder large-cube"
all_models='cpg-s cpg-m cpg-c cpg-h'

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

make_sweep() { # OBJECTS MODELS SEEDS TRIALS VARIANTS
    rm -rf "$sweep"
    mkdir -p "$sweep/figures/data"
    awk -v folder="$sweep" -v objects="$1" -v models="$2" -v seeds="$3" -v trials="$4" -v variants="$5" \
        -f "$source/tests/plots/made_up_sweep.awk" >"$work/runs"
    while read -r model run; do
        mkdir -p "$sweep/$run"
        awk -v folder="$sweep/$run" -v trials="$4" -v model="$model" -f "$source/tests/plots/made_up_run.awk"
    done <"$work/runs"
}

# Run draw-sweep; it must exit with STATUS, say one sentence that matches PATTERN, and leave no figures.
refuses() { # STATUS PATTERN ARGUMENT...
    expected=$1
    pattern=$2
    shift 2
    status=0
    "$source/plots/draw-sweep" "$@" >"$work/out" 2>"$work/error" || status=$?
    [ "$status" -eq "$expected" ] || fail "exit status $status, expected $expected: $(cat "$work/error")"
    [ "$(wc -l <"$work/error")" -eq 1 ] || fail "not one line: $(cat "$work/error")"
    grep -q -- "$pattern" "$work/error" || fail "'$pattern' is not in: $(cat "$work/error")"
    [ ! -s "$work/out" ] || fail 'printed paths of figures that were not drawn'
    [ -z "$(find "$sweep/figures" -mindepth 1 -not -path '*/data*')" ] || fail "left $(ls -A "$sweep/figures") behind"
}

# All figures are there in both formats, are what they claim to be, are listed, and nothing else is there.
drawn_in() { # OUT_DIR
    for figure in $figures; do
        "$svg_check" "$1/$figure.svg" || fail "$figure.svg is not well-formed SVG"
        [ "$(dd if="$1/$figure.png" bs=1 skip=1 count=3 2>/dev/null)" = PNG ] || fail "$figure.png is not a PNG"
        # An empty canvas of these sizes compresses to under 10 kB; a figure with curves and labels does not.
        [ "$(wc -c <"$1/$figure.png")" -gt 20000 ] || fail "$figure.png looks empty"
    done
    for figure in $figures; do printf '%s\n' "$1/$figure.svg" "$1/$figure.png"; done | sort >"$work/expected"
    sort "$work/out" | cmp - "$work/expected" || fail "printed: $(cat "$work/out")"
    find "$1" -type f -not -path '*/data/*' | sort | cmp - "$work/expected" || fail "drew: $(ls -A "$1")"
}

# The figure says so many times that something is not in the sweep.
lacks() { # FIGURE TIMES
    times=$(grep -c '<text>.*not in this sweep' "$sweep/figures/$1.svg" || true)
    [ "$times" -eq "$2" ] || fail "$1.svg says $times times that something is not in the sweep, expected $2"
}

case $3 in
draws_all_figures_of_a_sweep_as_svg_and_png)
    make_sweep "$all_objects" "$all_models" 2 150 -
    "$source/plots/draw-sweep" "$sweep" >"$work/out"
    drawn_in "$sweep/figures"
    for figure in $figures; do lacks "$figure" 0; done
    ;;
draws_what_a_sweep_has)
    # Of nine objects one, of four models two, of two ranks one: eight empty panels, two rows, two legends, four
    # bars, one panel.
    make_sweep large-cube 'cpg-m cpg-h' 1 150 -
    "$source/plots/draw-sweep" "$sweep" >"$work/out"
    drawn_in "$sweep/figures"
    lacks fig5 8
    lacks fig6 2
    lacks fig7 1
    lacks fig8 1
    lacks table1 6
    lacks table2 10
    lacks contacts 10
    lacks rotation 8
    grep -q 'large cube, best runs: CPG-M seed 1, CPG-H seed 1' "$sweep/figures/fig6.svg" ||
        fail 'fig6 does not name its runs'
    ;;
draws_a_sweep_of_one_short_run)
    make_sweep small-sphere cpg-s 1 3 -
    "$source/plots/draw-sweep" "$sweep" >"$work/out"
    drawn_in "$sweep/figures"
    lacks fig7 2
    ;;
leaves_variants_out_and_says_so)
    make_sweep 'small-sphere large-cube' 'cpg-c cpg-h' 2 150 '- slippery'
    "$source/plots/draw-sweep" "$sweep" >"$work/out"
    drawn_in "$sweep/figures"
    for figure in $figures; do
        grep -q 'without its variants' "$sweep/figures/$figure.svg" ||
            fail "$figure.svg does not say that variants are left out"
        mv "$sweep/figures/$figure.svg" "$work/$figure.svg"
    done
    # Nothing of a variant is read.
    rm -r "$sweep/slippery"
    "$source/plots/draw-sweep" "$sweep" >"$work/out"
    for figure in $figures; do
        cmp "$sweep/figures/$figure.svg" "$work/$figure.svg" || fail "$figure.svg is another one"
    done
    ;;
has_nothing_to_draw_of_variants_alone)
    make_sweep small-sphere 'cpg-c cpg-h' 2 150 slippery
    refuses 0 'nothing to draw' "$sweep"
    ;;
finds_the_stretches_of_contact)
    # The index touches at the ends of the 2nd, 3rd and 6th step of 10 ms, the thumb at the end of the 1st.
    printf '%s\n' '# made up' time_s,index_contact_n,thumb_contact_n \
        0.01,0,1 0.02,1,0 0.03,0.5,0 0.04,0,0 0.05,0,0 0.06,2,0 |
        awk -v run=114 -f "$source/plots/sweep/contacts.awk" >"$work/out"
    printf '%s\n' 114,thumb,0,0.01 114,index,0.01,0.03 114,index,0.05,0.06 | cmp - "$work/out" ||
        fail "$(cat "$work/out")"
    ;;
takes_any_folder_name)
    sweep="$work/it's \`a\` \$sweep %d \"x\""
    make_sweep small-sphere 'cpg-c cpg-h' 2 150 -
    "$source/plots/draw-sweep" "$sweep" "$work/o'ut dir" >"$work/out"
    drawn_in "$work/o'ut dir"
    ;;
refuses_a_missing_file)
    for file in sweep.json table1.csv table2.csv figures/data/learning_curves.csv figures/data/best_runs.csv \
        small-sphere/cpg-c/seed-1/trajectory.csv small-sphere/cpg-c/seed-1/object_outline.csv \
        small-sphere/cpg-h/seed-2/trials.csv; do
        make_sweep small-sphere 'cpg-c cpg-h' 2 20 -
        rm "$sweep/$file"
        refuses 2 "no readable $file" "$sweep"
    done
    refuses 2 'not a folder' "$work/nowhere"
    refuses 2 'usage'
    ;;
refuses_a_missing_column)
    make_sweep small-sphere 'cpg-c cpg-h' 2 20 -
    sed 's/object_rad/angle/' "$sweep/small-sphere/cpg-h/seed-1/trajectory.csv" >"$work/other"
    mv "$work/other" "$sweep/small-sphere/cpg-h/seed-1/trajectory.csv"
    refuses 2 'trajectory.csv has no column object_rad' "$sweep"
    sed 's/paper_sd/sd/' "$sweep/table2.csv" >"$work/other" && mv "$work/other" "$sweep/table2.csv"
    refuses 2 'table2.csv has no column paper_sd' "$sweep"
    ;;
leaves_nothing_behind_when_gnuplot_fails)
    make_sweep small-sphere 'cpg-c cpg-h' 2 20 -
    sed '3,$d' "$sweep/small-sphere/cpg-h/seed-1/object_outline.csv" >"$work/other"
    mv "$work/other" "$sweep/small-sphere/cpg-h/seed-1/object_outline.csv"
    refuses 1 'gnuplot could not draw' "$sweep"
    ;;
says_that_gnuplot_is_missing)
    make_sweep small-sphere cpg-h 1 20 -
    mkdir "$work/bin"
    ln -s "$(command -v sh)" "$work/bin/sh"
    status=0
    env PATH="$work/bin" "$work/bin/sh" "$source/plots/draw-sweep" "$sweep" 2>"$work/error" || status=$?
    [ "$status" -eq 1 ] || fail "exit status $status, expected 1"
    grep -q 'gnuplot is not installed' "$work/error" || fail "said: $(cat "$work/error")"
    ;;
*) fail "no case $3" ;;
esac

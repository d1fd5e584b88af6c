#!/bin/sh
# test_performance.sh SOURCE_DIR SVG_CHECK CASE: one claim about plots/performance.gp or scripts/performance-table,
# on made-up speeds.
set -eu
source=$1
svg_check=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
growth="$work/it's growth.csv"

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

# A CSV as bench_growth writes it, with MADE-UP numbers; nothing here was measured.
make_growth() {
    awk 'function row(series, stepper, object, substeps, fingers, workers, quantity, value) {
        printf "%s,%s,%s,%s,%s,%s,%s,%.6g,%.6g,%.6g,5\n", series, stepper, object, substeps, fingers, \
            workers, quantity, \
            value, 0.9 * value, 1.1 * value
    }
    BEGIN {
        print "# made-up numbers\nseries,stepper,object,substeps,fingers,workers,quantity,median,least,most,repeats"
        row("memory", "fast", "small-sphere", 5, "", 1, "peak_resident_mb", 5.5)
        row("memory", "fast", "small-sphere", 5, "", 1, "further_worker_mb", 0.25)
        row("memory", "reference", "small-sphere", 5, "", 1, "peak_resident_mb", 7.5)
        row("memory", "reference", "small-sphere", 5, "", 1, "further_worker_mb", 0.75)
        split("small-sphere medium-cylinder large-cube", objects, " ")
        n = split("2 3 5 10 20 50 100", substeps, " ")
        for (o = 1; o <= 3; o++) {
            for (s = 1; s <= n; s++)
                row("substeps", "fast", objects[o], substeps[s], "", 1, "control_steps_per_s", 2e6 / o / substeps[s])
            for (s = 3; s < n; s++)
                row("substeps", "reference", objects[o], substeps[s], "", 1, "control_steps_per_s",
                    1e5 / o / substeps[s])
            for (f = 0; f <= 2; f++)
                row("fingers", "fast", objects[o], 5, f, 1, "control_steps_per_s", 900000 / (o + f))
            for (w = 1; w <= 4; w *= 2) {
                row("workers", "fast", objects[o], 5, "", w, "control_steps_per_s", 100000 * w * o)
                row("workers", "fast", objects[o], 5, "", w, "ratio_to_one_worker", 0.75 * w)
            }
        }
        split("small medium large", sizes, " "); split("sphere cylinder cube", shapes, " ")
        for (i = 1; i <= 3; i++) for (o = 1; o <= 3; o++)
            row("objects", "fast", sizes[i] "-" shapes[o], 5, "", 1, "control_steps_per_s", 100000 * (i + o))
    }' >"$growth"
}

draw() { # FORMAT
    gnuplot -d -e "growth='$(printf '%s' "$growth" | sed "s/'/''/g")'; output='$work/performance.$1'; format='$1'" \
        "$source/plots/performance.gp" 2>"$work/error"
}

has_line() { # LINE
    grep -qxF -- "$1" "$work/tables" || fail "no line '$1' in: $(cat "$work/tables")"
}

case $3 in
draws_speeds_as_svg_and_png)
    make_growth
    for format in svg png; do
        draw $format || fail "gnuplot: $(cat "$work/error")"
        [ ! -s "$work/error" ] || fail "gnuplot said: $(cat "$work/error")"
    done
    "$svg_check" "$work/performance.svg" || fail 'not well-formed SVG'
    [ "$(dd if="$work/performance.png" bs=1 skip=1 count=3 2>/dev/null)" = PNG ] || fail 'not a PNG'
    # An empty canvas of this size compresses to under 10 kB.
    [ "$(wc -c <"$work/performance.png")" -gt 20000 ] || fail 'the PNG looks empty'
    # Each shape at 2 and 4 workers has its ratio above its bar.
    for ratio in 1.50 3.00; do
        [ "$(grep -c ">$ratio<" "$work/performance.svg")" -eq 3 ] || fail "expected the ratio $ratio three times"
    done
    ;;
prints_the_tables)
    make_growth
    "$source/scripts/performance-table" "$growth" >"$work/tables"
    has_line '| fast | small-sphere | 1000 | 667 | 400 | 200 | 100 | 40.0 | 20.0 |'
    has_line '| reference | large-cube | - | - | 6.7 | 3.3 | 1.7 | 0.7 | - |'
    has_line '| fast | medium-cylinder | 450 | 300 | 225 |'
    has_line '| fast | large-cylinder | 500 |'
    has_line '| stepper | object | 1 worker | 2 workers | 4 workers |'
    has_line '| large-cube | 4 | 3.00 |'
    has_line '| reference | 7.5 | 0.75 |'
    ;;
refuses_no_file)
    status=0
    "$source/scripts/performance-table" "$work/nowhere.csv" >"$work/out" 2>"$work/error" || status=$?
    [ "$status" -eq 2 ] || fail "exit status $status, expected 2"
    grep -q 'usage' "$work/error" || fail "said: $(cat "$work/error")"
    ;;
*) fail "no case $3" ;;
esac

#!/bin/sh
# test_summarise_first.sh SOURCE_DIR CASE: one claim about scripts/summarise-first, on a made-up tree of runs.
#
# Every run has 502 trials. Trials 1 and 2 are 99 rad, which must not count; of the last 500, one half is m - 1 and the other
# m + 1, so that the run's mean is m. Over seeds 1, 2, 4: m = base + seed, whose mean is base + 7/3, standard deviation
# sqrt(((4/3)^2 + (1/3)^2 + (5/3)^2) / 2) = sqrt(7/3) = 1.5275, best base + 4. The bases are 0 to 14 in the summary's order.
set -eu
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
first=$work/first
objects='small-sphere medium-cylinder large-cube'
conditions='cpg-s cpg-m cpg-c cpg-h cpg-h-no-centre'

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

make_tree() {
    base=0
    for object in $objects; do
        for condition in $conditions; do
            centre=true
            [ "$condition" != cpg-h-no-centre ] || centre=false
            for seed in 1 2 4; do
                folder=$first/$object/$condition/seed-$seed
                mkdir -p "$folder"
                printf '{\n  "object": "%s",\n  "model": "%s",\n  "centre": %s,\n  "seed": %d,\n  "trials": 502\n}\n' \
                    "$object" "${condition%-no-centre}" $centre $seed >"$folder/run.json"
                awk -v m=$((base + seed)) 'BEGIN {
                    print "# made-up numbers\ntrial,rotation_rad,reward"
                    for (i = 1; i <= 502; i++) print i "," (i <= 2 ? 99 : i % 2 ? m - 1 : m + 1) ",0"
                }' >"$folder/trials.csv"
            done
            base=$((base + 1))
        done
    done
}

# The script must fail with PATTERN in its one sentence and write no summary.
refuses() { # PATTERN
    status=0
    "$source/scripts/summarise-first" -s '1 2 4' "$first" >"$work/out" 2>"$work/error" || status=$?
    [ "$status" -eq 1 ] || fail "exit status $status, expected 1"
    [ "$(wc -l <"$work/error")" -eq 1 ] || fail "not one line: $(cat "$work/error")"
    grep -q -- "$1" "$work/error" || fail "'$1' is not in: $(cat "$work/error")"
    [ "$(ls -A "$first" | wc -l)" -eq 3 ] || fail "left behind: $(ls -A "$first")"
}

has_line() { # FILE LINE
    grep -qxF -- "$2" "$1" || fail "no line '$2' in: $(cat "$1")"
}

make_tree
case $2 in
gives_mean_spread_and_best_beside_the_paper)
    "$source/scripts/summarise-first" -s '1 2 4' "$first" >"$work/out"
    printf '%s\n' "$first/summary.csv" "$first/summary.md" | cmp - "$work/out"
    [ "$(grep -vc '^#' "$first/summary.csv")" -eq 16 ] || fail 'expected a header and fifteen rows'
    # The paper's values are read from its printed tables, not from plots/paper.
    has_line "$first/summary.csv" 'object,model,centre,n,mean_rad,sd_rad,best_rad,paper_mean,paper_sd,paper_best'
    has_line "$first/summary.csv" 'small-sphere,cpg-s,true,3,2.3333,1.5275,4.0000,3.981,0.018,3.993'
    has_line "$first/summary.csv" 'medium-cylinder,cpg-h,true,3,10.3333,1.5275,12.0000,4.429,0.074,4.528'
    has_line "$first/summary.csv" 'large-cube,cpg-h,false,3,16.3333,1.5275,18.0000,1.799,,'
    has_line "$first/summary.md" '| large-cube | CPG-C | 14.33 ± 1.53 (16.00) | 3 | 3.514 ± 0.009 (3.521) | - |'
    has_line "$first/summary.md" '| small-sphere | CPG-H | 5.33 ± 1.53 (7.00) | 3 | 5.686 ± 0.063 (5.773) | 5.692 |'
    has_line "$first/summary.md" '| small-sphere | CPG-H without centre | 6.33 ± 1.53 (8.00) | 3 | - | 2.829 |'
    ;;
is_what_first_results_draws)
    "$source/scripts/summarise-first" -s '1 2 4' "$first" >"$work/out"
    for format in svg png; do
        gnuplot -d -e "summary='$first/summary.csv'; output='$work/first.$format'; format='$format'" \
            "$source/plots/first_results.gp" 2>"$work/error" || fail "$(cat "$work/error")"
        [ ! -s "$work/error" ] || fail "gnuplot said: $(cat "$work/error")"
        [ "$(wc -c <"$work/first.$format")" -gt 20000 ] || fail "first.$format looks empty"
    done
    ;;
refuses_missing_and_incomplete_runs_and_names_them)
    rm -r "$first/large-cube/cpg-m/seed-4"
    sed '$d' "$first/small-sphere/cpg-h/seed-2/trials.csv" >"$work/cut"
    mv "$work/cut" "$first/small-sphere/cpg-h/seed-2/trials.csv"
    refuses 'small-sphere/cpg-h/seed-2 (501 of 502 trials), large-cube/cpg-m/seed-4 (missing)$'
    ;;
refuses_a_run_in_the_wrong_folder)
    cp "$first/large-cube/cpg-s/seed-2/run.json" "$first/large-cube/cpg-s/seed-1/run.json"
    refuses 'large-cube/cpg-s/seed-1 (run.json is of another run)$'
    ;;
refuses_too_short_a_run)
    sed 's/502/499/' "$first/large-cube/cpg-s/seed-1/run.json" >"$work/short"
    mv "$work/short" "$first/large-cube/cpg-s/seed-1/run.json"
    refuses 'large-cube/cpg-s/seed-1 (has 499 trials, at least 500 are needed)$'
    ;;
*) fail "no case $2" ;;
esac

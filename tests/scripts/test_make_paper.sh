#!/bin/sh
# test_make_paper.sh SOURCE_DIR BUILD_DIR CASE: one claim about `make paper`, with the programs in
# BUILD_DIR as they are.
set -eu
source=$1
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset MAKEFLAGS MAKELEVEL MFLAGS TWIDDLE_MODELS # of the make that runs the tests

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

# `program` counts as up to date, so that nothing is built.
paper() { # ARGUMENT...
    make --no-print-directory -C "$source" -o program paper BUILD="$build" "$@"
}

complete_runs() { # RESULTS
    find "$1" -name trials.csv 2>/dev/null | wc -l
}

# Start a smoke sweep and kill make and its workers, of one process group, with some of the 12 runs complete.
kill_half_way() { # RESULTS
    setsid make --no-print-directory -C "$source" -o program paper BUILD="$build" SWEEP=smoke JOBS=2 RESULTS="$1" \
        >"$work/killed.log" 2>&1 &
    group=$!
    tries=0
    while [ "$(complete_runs "$1")" -lt 3 ]; do
        tries=$((tries + 1))
        [ "$tries" -le 3000 ] || fail "no three runs in a minute: $(cat "$work/killed.log")"
        sleep 0.02
    done
    kill -KILL "-$group"
    wait "$group" 2>/dev/null || true
    [ "$(complete_runs "$1")" -lt 12 ] || fail 'the sweep ended before it was killed'
    [ ! -e "$1/table1.csv" ] || fail 'there are tables of a sweep that was killed'
}

case $3 in
killed_half_way_and_started_again_gives_the_same_tables)
    kill_half_way "$work/killed"
    for results in killed whole; do
        paper SWEEP=smoke JOBS=2 RESULTS="$work/$results" >"$work/$results.log" 2>&1 ||
            fail "$(cat "$work/$results.log")"
    done
    grep -q '12 of 12 runs are complete.* before' "$work/killed.log" || fail "kept no run: $(cat "$work/killed.log")"
    for table in table1.csv table2.csv tables.md; do
        cmp "$work/killed/$table" "$work/whole/$table" || fail "$table differs"
    done
    for trials in "$work"/whole/*/*/seed-*/trials.csv; do
        cmp "$trials" "$work/killed/${trials#"$work/whole/"}" || fail "${trials#"$work/whole/"} differs"
    done
    ;;
set_up_has_a_folder_of_its_own)
    paper -n SWEEP=smoke >"$work/default"
    grep -q -- '--out results/smoke ' "$work/default" || fail "$(cat "$work/default")"
    ! grep -q -- '--setup' "$work/default" || fail "$(cat "$work/default")"
    for setup in near experiments/setups/near.toml; do
        paper -n SWEEP=smoke SETUP=$setup >"$work/near"
        grep -q -- "--out results/smoke-near .*--setup $setup" "$work/near" || fail "$(cat "$work/near")"
        grep -q 'summarize results/smoke-near' "$work/near" || fail "$(cat "$work/near")"
    done
    ;;
stops_at_a_manifest_or_set_up_that_is_not_there)
    for wrong in SWEEP=nowhere 'SWEEP=smoke SETUP=nowhere'; do
        status=0
        # shellcheck disable=SC2086 # two words are two arguments
        paper $wrong RESULTS="$work/out" >"$work/log" 2>&1 || status=$?
        [ "$status" -eq 2 ] || fail "exit status $status, expected make's 2"
        grep -q '^twiddle: .*nowhere' "$work/log" || fail "said: $(cat "$work/log")"
        [ ! -e "$work/out" ] || fail 'made a folder'
    done
    ;;
says_that_gnuplot_is_missing)
    mkdir "$work/bin"
    status=0
    env PATH="$work/bin" "$(command -v make)" --no-print-directory -C "$source" gnuplot >"$work/log" 2>&1 || status=$?
    [ "$status" -eq 2 ] || fail "exit status $status, expected make's 2"
    grep -q '^make: gnuplot is not installed; scripts/install-deps installs it$' "$work/log" ||
        fail "$(cat "$work/log")"
    ;;
*) fail "no case $3" ;;
esac

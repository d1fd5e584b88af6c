#!/usr/bin/env bash
# `make paper SWEEP=smoke ENGINE=slurm` on a Slurm of one node: a task is killed and requeued, and all results are
# those of `make paper SWEEP=smoke` to the byte. Usage: test_one_node.sh SOURCE_FOLDER BUILD_FOLDER; exit status 77
# where it cannot run.
set -euo pipefail

source=$1
build=$2
(($(id -u) == 0)) || {
    echo "skipped: only root can start a Slurm of its own"
    exit 77
}

work=$(mktemp -d)
make_process=
clean_up()
{
    [[ -z $make_process ]] || kill "$make_process" 2>/dev/null || true
    [[ ! -d $work/slurm ]] || "$source/tests/slurm/one-node" stop "$work/slurm"
    rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

fail()
{
    echo "FAILED: $1" >&2
    [[ ! -f $work/log ]] || cat "$work/log" >&2
    tail -n 50 "$work"/cluster-slurm/* >&2 2>/dev/null || true
    exit 1
}

# What a user types, but for the build, and with results in a folder of the test. It takes some seconds.
paper()
{
    timeout 100 make --no-print-directory -C "$source" -o program paper SWEEP=smoke BUILD="$build" \
        RESULTS="$work/$1" "${@:2}"
}

# The processes of the task that does a run, by its index: twiddle and its worker, one a line.
task_processes()
{
    pgrep -f -- "--out $work/cluster --only $1\$"
}

# Whether the run in a folder has made some trials, but not all.
is_half_trained()
{
    [[ ! -e $1/trials.csv ]] && (($(grep -c '^[0-9]' "$1/trials.csv.part" 2>/dev/null) > 20))
}

# Stop a run while it is being trained, and set run (its index) and processes. A run of this sweep takes some tenths of
# a second: one that ends before it is stopped is let go, and the next one is tried.
stop_a_run()
{
    local part folder
    while kill -0 "$make_process" 2>/dev/null; do
        part=$(find "$work/cluster" -name trials.csv.part -print -quit 2>/dev/null) || continue
        [[ -n $part ]] || continue
        folder=${part%/*}
        is_half_trained "$folder" || continue
        run=$(sed -n 's/.*"command": .* --only \([0-9]*\)".*/\1/p' "$folder/run.json")
        mapfile -t processes < <(task_processes "$run")
        kill -STOP "${processes[@]}" 2>/dev/null || continue
        ! is_half_trained "$folder" || return 0
        kill -CONT "${processes[@]}" 2>/dev/null || true
    done
    return 1
}

# Slurm's name of the task that does a run, by its index.
task_of()
{
    local id
    for id in $(squeue --noheader --array --states=RUNNING --format=%i); do
        [[ ${id#*_} != $(($1 % array_size)) ]] || echo "$id"
    done
}

# All files of both folders, run.json but for the name of the folder in it.
same_results()
{
    local run_json
    diff -r --exclude=run.json "$work/local" "$work/cluster" || return 1
    for run_json in $(cd "$work/local" && find . -name run.json); do
        diff "$work/local/$run_json" <(sed "s|--out $work/cluster |--out $work/local |" "$work/cluster/$run_json") ||
            return 1
    done
}

paper local >"$work/log" 2>&1 || fail "the local sweep"
points_to_it=$("$source/tests/slurm/one-node" start "$work/slurm") || fail "Slurm does not start"
eval "$points_to_it"

array_size=$(scontrol show config | awk '$1 == "MaxArraySize" { print $3 }')

paper cluster ENGINE=slurm THROTTLE=2 >"$work/log" 2>&1 &
make_process=$!
stop_a_run || fail "no run could be stopped while it was trained"
task=$(task_of "$run")
[[ -n $task ]] || fail "no running task does the run $run"
scontrol requeue "$task" || fail "scontrol requeue $task"
kill -KILL "${processes[@]}" 2>/dev/null || true # no time to end its trial
status=0
wait "$make_process" || status=$?
make_process=
((status == 0)) || fail "make paper ended with status $status"
[[ $(scontrol show job "$task") == *" Restarts=1 "* ]] || fail "the task $task was not started again"
[[ $(<"$work/log") == *"$work/cluster/table2.csv"* ]] || fail "make paper does not name the tables"
same_results || fail "results differ from those of the local run"

paper cluster ENGINE=slurm >"$work/log" 2>&1 || fail "a second start"
[[ $(<"$work/log") == *": 0 runs, and the job that makes the results"* ]] || fail "complete runs were submitted again"

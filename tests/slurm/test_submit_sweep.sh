#!/usr/bin/env bash
# scripts/submit-sweep against stand-ins for Slurm's commands and for twiddle: what is submitted, and what it says where
# it cannot. Each function is one claim. Usage: test_submit_sweep.sh PATH_OF_SUBMIT_SWEEP
set -euo pipefail

submit_sweep=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# stand_in NAME BODY: a program NAME on the PATH that submit-sweep sees.
stand_in()
{
    printf '#!/bin/bash\n%s\n' "$2" >"$work/bin/$1"
    chmod +x "$work/bin/$1"
}

# cluster MAX_ARRAY_SIZE MISSING...: a Slurm with an empty queue that takes every job, and a sweep of which some runs
# are missing. sbatch logs its arguments and keeps the job's script as job-N, by the job's number N.
cluster()
{
    rm -rf "$work"
    mkdir -p "$work/bin" "$work/my sweeps"
    local name
    for name in bash env mkdir awk id timeout grep head wc sleep cat; do
        ln -s "$(command -v "$name")" "$work/bin/$name"
    done
    touch "$work/log" "$work/queue"
    echo 0 >"$work/jobs"
    stand_in scontrol "echo 'MaxArraySize            = $1'"
    stand_in squeue "cat '$work/queue'"
    stand_in scancel "echo scancel \"\$@\" >>'$work/log'"
    stand_in sbatch "cd '$work'; job=\$((\$(cat jobs) + 1)); echo \$job >jobs; echo \"\$@\" >>log
cat >job-\$job; echo \$job"
    shift
    missing=("$@")
    has_twiddle "printf '%s\n' ${missing[*]+${missing[*]}}"
    ((${#missing[@]})) || has_twiddle ""
}

# has_twiddle BODY: makes the sweep's folder, and does what BODY says.
has_twiddle()
{
    stand_in twiddle "while [[ \$1 != --out ]]; do shift; done; mkdir -p \"\$2\"; $1"
}

# expect STATUS ARGUMENT... -- [OUTPUT_PART...]: run it in the scratch folder, check its exit status and that its
# output has every part.
expect()
{
    local wanted=$1 status=0 arguments=() part
    shift
    while [[ $1 != -- ]]; do
        arguments+=("$1")
        shift
    done
    shift
    output=$(cd "$work" && PATH=$work/bin "$submit_sweep" --program "$work/bin/twiddle" "${arguments[@]}" \
        2>&1 </dev/null) || status=$?
    [[ $status == "$wanted" ]] || refuse "exit status $status, expected $wanted"
    for part in "$@"; do
        [[ $output == *"$part"* ]] || refuse "no '$part' in the output"
    done
}

refuse()
{
    echo "FAILED ${FUNCNAME[2]}: $1" >&2
    printf 'output: %s\nlog: %s\n' "$output" "$(<"$work/log")" >&2
    exit 1
}

# expect_call N PART...: the N-th call that is logged has every part.
expect_call()
{
    local call part
    call=$(sed -n "$1p" "$work/log")
    for part in "${@:2}"; do
        [[ " $call " == *"$part"* ]] || refuse "no '$part' in the call $1"
    done
}

expect_calls()
{
    [[ $(wc -l <"$work/log") == "$1" ]] || refuse "calls other than $1"
}

one_sentence()
{
    [[ $output != *$'\n'* ]] || refuse "more than one line"
}

missing_runs_are_one_array_and_the_results_wait_for_it()
{
    cluster 1001 3 4 5 9 11 12
    expect 0 --no-wait --throttle 2 --sbatch "--partition=short --time=5" m.toml out make results -- \
        "6 runs" "squeue --jobs=1,2"
    expect_calls 2
    expect_call 1 " --array=3-5,9,11-12%2 " " --mem=200M " " --requeue " " --partition=short --time=5 "
    expect_call 2 " --dependency=afterok:1 " " --kill-on-invalid-dep=yes " " --partition=short --time=5 "
}

jobs_do_what_is_meant()
{
    cluster 4 2 6
    expect 0 --no-wait "my sweeps/it's.toml" "my sweeps/out" make "a b" c -- "2 runs"
    stand_in twiddle 'printf "<%s>" twiddle "$@"'
    stand_in make 'printf "<%s>" make "$@"'
    output=$(cd "$work" && PATH=$work/bin SLURM_ARRAY_TASK_ID=2 bash job-2)
    [[ $output == "run 6"$'\n'"<twiddle><sweep><my sweeps/it's.toml><--out><my sweeps/out><--only><6>" ]] ||
        refuse "another run"
    output=$(cd "$work" && PATH=$work/bin bash job-3)
    [[ $output == "<make><a b><c>" ]] || refuse "another command for the results"
}

more_runs_than_max_array_size_are_several_arrays()
{
    cluster 4 1 2 3 4 9 11
    expect 0 --no-wait m.toml out make -- "6 runs"
    expect_calls 4
    expect_call 1 " --array=1-3 "
    expect_call 2 " --array=0 "
    expect_call 3 " --array=1,3 "
    expect_call 4 " --dependency=afterok:1:2:3 "
    [[ $(<"$work/log") != *afterany* ]] || refuse "arrays wait for each other without a throttle"
}

arrays_with_a_throttle_follow_each_other()
{
    cluster 4 1 4 9
    expect 0 --no-wait --throttle 3 m.toml out make -- "3 runs"
    expect_call 1 " --array=1%3 "
    expect_call 2 " --array=0%3 " " --dependency=afterany:1 "
    expect_call 3 " --array=1%3 " " --dependency=afterany:2 "
    expect_call 4 " --dependency=afterok:1:2:3 "
}

complete_sweep_submits_the_results_alone()
{
    cluster 1001
    expect 0 --no-wait m.toml out make -- "0 runs"
    expect_calls 1
    [[ $(<"$work/log") != *--dependency* ]] || refuse "a dependency on nothing"
}

refused_job_withdraws_the_others()
{
    cluster 4 1 5
    stand_in sbatch "cd '$work'; [[ ! -e job-1 ]] || { echo 'sbatch: error: limit' >&2; exit 1; }
: >job-1; echo \"\$@\" >>log; echo 1"
    expect 1 --no-wait m.toml out make -- "sbatch: error: limit" "Slurm refuses a job"
    expect_calls 2
    expect_call 2 "scancel 1"
}

jobs_in_the_queue_are_not_submitted_twice()
{
    cluster 1001 0 1
    printf '%s\n' "7|PENDING|twiddle:$work/out" "7|RUNNING|twiddle:$work/out" "8|PENDING|twiddle-results:$work/out" \
        "9|RUNNING|twiddle:$work/other" "5|FAILED|twiddle:$work/out" >"$work/queue"
    expect 0 --no-wait m.toml out make -- "nothing new is submitted" "scancel 7 8;"
    expect_calls 0
}

# A queue in which the first look finds nothing, and the later ones the results' job, ended.
results_end_as()
{
    stand_in squeue "[[ ! -s '$work/log' ]] || echo '2|$1|twiddle-results:$work/out'"
}

waiting_ends_with_what_the_results_print()
{
    cluster 1001 0
    results_end_as COMPLETED
    mkdir "$work/out-slurm"
    echo "results/table1.csv" >"$work/out-slurm/results-2.log"
    expect 0 m.toml out make -- "results/table1.csv"
}

failed_run_fails_with_its_reason()
{
    cluster 1001 0
    results_end_as CANCELLED
    mkdir "$work/out-slurm"
    echo "twiddle: 1 of 1 run failed; the first: a/b/seed-1: disk full" >"$work/out-slurm/runs-1_0.log"
    expect 1 m.toml out make -- "1 run not complete (the first that says why: a/b/seed-1: disk full)" \
        "logs are in out-slurm"
}

failed_results_fail()
{
    cluster 1001
    stand_in squeue "[[ ! -s '$work/log' ]] || echo '1|TIMEOUT|twiddle-results:$work/out'"
    expect 1 m.toml out make -- "the results could not be made: their job ended as TIMEOUT; see out-slurm/results-1.log"
}

missing_slurm_is_one_sentence()
{
    cluster 1001 0
    rm "$work/bin/sbatch"
    expect 1 m.toml out make -- "sbatch is not installed here"
    one_sentence
    [[ ! -e $work/out && ! -e $work/out-slurm ]] || refuse "something was made"
}

missing_program_is_one_sentence()
{
    cluster 1001 0
    expect 1 --program nothing m.toml out make -- "'nothing' is no program"
    one_sentence
}

silent_controller_is_one_sentence()
{
    cluster 1001 0
    stand_in scontrol 'echo "slurm_load_ctl_conf error: Unable to contact slurm controller" >&2; exit 1'
    expect 1 m.toml out make -- "Slurm's controller does not answer: slurm_load_ctl_conf error"
    one_sentence
    [[ ! -e $work/out && ! -e $work/out-slurm ]] || refuse "something was made"
}

slurm_without_arrays_is_one_sentence()
{
    cluster 0 0
    expect 1 m.toml out make -- "takes no job arrays (MaxArraySize is '0')"
    one_sentence
}

refused_sweep_is_the_programs_sentence()
{
    cluster 1001
    has_twiddle "echo 'twiddle: m.toml: there is no such file' >&2; exit 2"
    expect 2 m.toml out make -- "twiddle: m.toml: there is no such file"
    one_sentence
    expect_calls 0
}

unwritable_logs_are_one_sentence()
{
    cluster 1001 0
    touch "$work/out-slurm"
    expect 1 m.toml out make -- "cannot write logs into the folder 'out-slurm'"
    one_sentence
    expect_calls 0
}

wrong_use_is_one_sentence()
{
    cluster 1001 0
    local each
    for each in "--throttle 0" "--throttle x" "--sbatch" "--foo"; do
        # shellcheck disable=SC2086 # an option and its value
        expect 2 $each -- "submit-sweep: $each" "usage:"
        one_sentence
    done
    expect 2 m.toml out -- "an argument is missing"
    expect_calls 0
}

claims=(
    missing_runs_are_one_array_and_the_results_wait_for_it
    jobs_do_what_is_meant
    more_runs_than_max_array_size_are_several_arrays
    arrays_with_a_throttle_follow_each_other
    complete_sweep_submits_the_results_alone
    refused_job_withdraws_the_others
    jobs_in_the_queue_are_not_submitted_twice
    waiting_ends_with_what_the_results_print
    failed_run_fails_with_its_reason
    failed_results_fail
    missing_slurm_is_one_sentence
    missing_program_is_one_sentence
    silent_controller_is_one_sentence
    slurm_without_arrays_is_one_sentence
    refused_sweep_is_the_programs_sentence
    unwritable_logs_are_one_sentence
    wrong_use_is_one_sentence
)
for claim in "${claims[@]}"; do
    "$claim"
    echo "passed $claim"
done

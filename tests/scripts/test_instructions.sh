#!/bin/sh
# test_instructions.sh SOURCE_DIR CXX CASE: one claim about what `make bench-instructions` is made of:
# scripts/piece-of-address, bench/bench_instructions.py and scripts/instructions-table. The program, valgrind and
# addr2line are stand-ins, and their numbers made up; only piece-of-address meets a real program.
set -eu
source=$1
cxx=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

has_line() { # LINE
    grep -qxF -- "$1" "$work/printed" || fail "no line '$1' in: $(cat "$work/printed")"
}

says() { # SENTENCE
    grep -qF -- "$1" "$work/error" || fail "said: $(cat "$work/error")"
    [ "$(wc -l <"$work/error")" -eq 1 ] || fail "more than a line: $(cat "$work/error")"
}

stand_in() { # NAME, its text on standard input
    { echo '#!/bin/sh'; cat; } >"$work/bin/$1"
    chmod +x "$work/bin/$1"
}

# A trial's row is its number. Of each of the 90,000 control steps callgrind counts 100 instructions in the dynamics,
# 20 in the learner (another count if it is told to leave out what resuming takes), and 3 in another library; what a
# call takes, a line of its own, is in the called function's lines already.
stand_ins() { # LEARNER_AT_THE_END
    mkdir -p "$work/bin" "$work/lines/bin"
    stand_in twiddle <<'END'
while [ $# -gt 0 ]; do
    case $1 in
    --trials) trials=$2 ;;
    --out) out=$2 ;;
    --resume) resume=1 ;;
    esac
    shift
done
mkdir -p "$out"
if [ "${resume:-}" ]; then
    grep -q '"state": "running"' "$out/run.json" || exit 1
    [ "$(tail -n 1 "$out/trials.csv.part")" = 4700, ] || exit 1
    rm "$out/trials.csv.part"
fi
printf '{\n  "state": "complete",\n  "git_commit": "abc",\n  "compiler": "GCC 1"\n}\n' >"$out/run.json"
{ printf '# made-up numbers\ntrial,\n'; seq -f '%.0f,' "$trials"; } >"$out/trials.csv"
END
    cp "$work/bin/twiddle" "$work/lines/bin/twiddle"
    stand_in valgrind <<END
[ "\$1" != --version ] || { echo valgrind-1; exit; }
learner=1800000
while [ "\${1#--}" != "\$1" ]; do
    case \$1 in
    --callgrind-out-file=*) out=\${1#*=} ;;
    --toggle-collect=twiddle::runs::TrainingSession::resume*) learner=\$((90000 * $1)) ;;
    esac
    shift
done
"\$@"
cat >"\$out" <<CALLGRIND
summary: \$((9000000 + learner + 270000))
ob=\$1
fn=one
0x1010 8000000
0x1014 1000000
cfn=other
calls=1 0x1020
0x1014 10800000
fn=other
0x1020 \$learner
ob=/lib/another.so
fn=elsewhere
0x1010 270000
CALLGRIND
END
    stand_in addr2line <<'END'
while read -r address; do
    printf '0x%016x\n' "$address"
    case $address in
    0x1020) printf 'draw\n/x/learner/src/random.c:3\n' ;;
    *) printf 'dot\n/x/vector.h:9\nstep\n/x/harness/sim/fast/finger_dynamics.cpp:8 (discriminator 2)\n' ;;
    esac
done
END
    stand_in objcopy <<'END'
cp "$4" "$5"
END
}

bench() { # [RECORDED]
    status=0
    PATH="$work/bin:$PATH" python3 -B "$source/bench/bench_instructions.py" --program "$work/bin/twiddle" \
        --lines "$work/lines/bin/twiddle" --out "$work/out/new.csv" --recorded "${1:-$work/nowhere.csv}" \
        >"$work/printed" 2>"$work/error" || status=$?
}

write_csv() { # FILE DYNAMICS
    cat >"$1" <<END
# made-up numbers
object,trials,total_m,control_step,dynamics,rest
small-sphere,1-300,2500,27800,$2,10
medium-cylinder,1-300,4260,47300,4000,20
small-sphere,4701-5000,2000,22000,1000,30
medium-cylinder,4701-5000,4000,44000,2000,40
END
}

case $3 in
inlined_helpers_count_for_the_piece_that_uses_them)
    mkdir -p "$work/harness/sim/fast" "$work/controller/src"
    cd "$work"
    echo 'inline double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1]; }' >vector.h
    cat >harness/sim/fast/finger_dynamics.cpp <<'END'
#include "../../../vector.h"
double push(const double *a, const double *b) { return dot(a, b); }
END
    cat >controller/src/controller.c <<'END'
extern "C" double twd_controller_torque(double a) { return a * 3; }
extern "C" double twd_controller_tick(double a) { return a * 5; }
extern "C" double unnamed(double a) { return a * 7; }
END
    printf '%s\n' 'double nobodys(double a) { return a * 9; }' 'int main() { return 0; }' >main.cpp
    "$cxx" -O2 -g -o program -x c++ main.cpp "$work/harness/sim/fast/finger_dynamics.cpp" \
        "$work/controller/src/controller.c"
    nm -C program | grep -E ' T (push|twd_|unnamed|nobodys)' >functions
    sed 's/ .*//; s/^/0x/' functions | "$source/scripts/piece-of-address" program | cut -f 2 >pieces
    sed 's/.* T //; s/(.*//' functions | paste -d : - pieces >printed
    has_line 'push:dynamics'
    has_line 'twd_controller_torque:gravity and PD'
    has_line 'twd_controller_tick:CPGs and gate'
    has_line 'unnamed:CPGs and gate'
    has_line 'nobodys:rest'
    ;;
both_ends_of_nine_runs_are_counted_by_piece)
    stand_ins 10
    bench
    [ $status -eq 0 ] || fail "exit status $status: $(cat "$work/error")"
    grep -v '^#' "$work/out/new.csv" >"$work/rows"
    [ "$(wc -l <"$work/rows")" -eq 19 ] || fail "other rows: $(cat "$work/rows")"
    cut -d , -f 1-5,13,14 "$work/rows" >"$work/printed"
    has_line 'object,trials,total_m,control_step,dynamics,learner,rest'
    has_line 'small-sphere,1-300,11,123,100,20,3'
    has_line 'large-cube,4701-5000,10,113,100,10,3'
    ;;
changes_of_more_than_one_percent_are_told)
    stand_ins 10
    bench
    sed 's/small-cube,1-300,11,123,100/small-cube,1-300,11,124,80/' "$work/out/new.csv" >"$work/recorded.csv"
    bench "$work/recorded.csv"
    has_line "against $work/recorded.csv: changes of more than 1 %:"
    has_line 'small-cube 1-300: dynamics 80 -> 100 (+25.0 %)'
    [ "$(grep -c ' -> ' "$work/printed")" -eq 1 ] || fail "tells more: $(cat "$work/printed")"
    cp "$work/out/new.csv" "$work/recorded.csv"
    bench "$work/recorded.csv"
    has_line "against $work/recorded.csv: no change of more than 1 %"
    bench
    has_line "$work/nowhere.csv is not there: nothing to compare with"
    ;;
refuses_lines_of_another_program)
    stand_ins 10
    echo '# another' >>"$work/lines/bin/twiddle"
    bench
    [ $status -eq 1 ] || fail "exit status $status"
    says 'with -g: its machine code differs'
    [ ! -e "$work/out" ] || fail 'wrote something'
    ;;
refuses_a_count_of_what_resuming_takes)
    stand_ins 41
    bench
    [ $status -eq 1 ] || fail "exit status $status"
    says 'what resuming takes was counted too'
    ;;
prints_two_counts_side_by_side)
    write_csv "$work/before.csv" 2000
    write_csv "$work/after.csv" 500
    "$source/scripts/instructions-table" "$work/before.csv" "$work/after.csv" >"$work/printed"
    has_line '| small-sphere | 1-300 | 2.500 | 2.500 | 1.00 | 27800 | 27800 | 1.00 |'
    has_line '| sum of small-sphere, medium-cylinder and large-cube | 1-300 | 6.760 | 6.760 | 1.00 | | | |'
    has_line '| all | 37550 | 37550 | 1.00 | 33000 | 33000 | 1.00 |'
    has_line '| dynamics | 3000 | 2250 | 0.75 | 1500 | 1500 | 1.00 |'
    "$source/scripts/instructions-table" "$work/before.csv" >"$work/printed"
    has_line '| small-sphere | 1-300 | 2.500 | 27800 |'
    has_line '| dynamics | 3000 | 1500 |'
    ;;
refuses_no_table)
    status=0
    "$source/scripts/instructions-table" "$work/nowhere.csv" >"$work/printed" 2>"$work/error" || status=$?
    [ $status -eq 2 ] || fail "exit status $status, expected 2"
    says usage
    ;;
*) fail "no case $3" ;;
esac

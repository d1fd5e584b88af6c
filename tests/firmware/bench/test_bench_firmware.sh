#!/usr/bin/env bash
# test_bench_firmware.sh SOURCE_DIR IMAGES CLAIM: one claim about firmware/bench/bench_firmware.py, on made-up counts
# or on the images that `make firmware` builds.
set -euo pipefail

source=$1
images=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail()
{
    echo "FAILED: $1" >&2
    exit 1
}

# bench STATUS ARGUMENT...: run it; its output is then in $work/output.
bench()
{
    local wanted=$1 status=0
    shift
    python3 -B "$source/firmware/bench/bench_firmware.py" --out "$work/out.csv" "$@" >"$work/output" 2>&1 || status=$?
    [[ $status == "$wanted" ]] || fail "exit status $status, expected $wanted; it said: $(<"$work/output")"
}

# A stand-in for firmware/emulators/run with MADE-UP counts, nothing here was measured: the seven oscillators take 400
# in fixed point, 900 in float and 1,000 with the C library, the whole tick 100 more.
make_up_counts()
{
    mkdir -p "$work/images/virt-O2/bin"
    touch "$work/images/virt-O2/bin/"{bench_twiddle,bench_twiddle_fixed,bench_libm}
    cat >"$work/run" <<'END'
#!/bin/bash
case ${@: -1} in
*_fixed) seven=400 ;;
*twiddle) seven=900 ;;
*) seven=1000 ;;
esac
while [[ $1 == --* ]]; do
    if [[ $1 == --counts ]]; then
        echo "function,part,calls,total,least,most" >"$2"
        out=$2
    fi
    cost=$seven
    [[ $2 == seven_tick ]] || cost=$((seven + 100))
    [[ $1 != --count ]] || echo "$2,,2,$((2 * cost)),$((cost - 1)),$((cost + 1))" >>"$out"
    shift 2
done
echo "error_1e-9 0000002500"
END
    chmod +x "$work/run"
}

has_line()
{
    grep -qxF -- "$1" "$work/output" || fail "no line '$1' in: $(<"$work/output")"
}

case $3 in
prints_means_ratios_and_goals)
    make_up_counts
    bench 0 --run "$work/run" --images "$work/images" --boards virt
    has_line '| RV32IMAC | fixed | 400 (401) | 100 | 500 (501) | 500 (501) | 500 (501) | 500 (501) | 500 (501) |'
    has_line '| RV32IMAC | twiddle, float | 900 | 901 | 2.25 | 1.00 | 2.5e-06 |'
    has_line '| RV32IMAC | C library, float | 1,000 | 1,001 | 2.50 | 1.11 | 2.5e-06 |'
    has_line '| RV32IMAC | twiddle, fixed | 400 | 600 | yes |'
    grep -qxF 'virt,RV32IMAC,instructions,"twiddle, fixed",whole tick,,2,500.000,499,501,' "$work/out.csv" ||
        fail "the CSV is: $(<"$work/out.csv")"
    ;;
counts_the_same_again)
    bench 0 --run "$source/firmware/emulators/run" --images "$images" --boards mps2-an386
    mv "$work/out.csv" "$work/first.csv"
    bench 0 --run "$source/firmware/emulators/run" --images "$images" --boards mps2-an386
    cmp "$work/first.csv" "$work/out.csv" >&2 || fail 'two runs differ'
    ;;
says_where_the_instructions_go)
    bench 0 --run "$source/firmware/emulators/run" --images "$images" --boards mps2-an386
    # Inlined functions of the source, too; the shares of an operation make up the whole.
    grep -q '^| whole tick | twd_filter_advance | ' "$work/output" || fail "no filters in the tick: $(<"$work/output")"
    awk -F ' \\| ' '/^Where/ { table++ }
        /^\| (whole tick|torques|learn) \|/ { sum[table $1] += $4 }
        END {
            for (key in sum) if (sum[key] < 99 || sum[key] > 101) { print key, sum[key]; bad = 1 }
            exit bad || length(sum) != 6
        }' "$work/output" >&2 || fail 'shares do not sum to 100 %'
    ;;
tells_an_image_that_fails)
    make_up_counts
    printf '#!/bin/bash\necho "no such board" >&2\nexit 3\n' >"$work/run"
    bench 1 --run "$work/run" --images "$work/images" --boards virt
    has_line 'bench-firmware: bench_twiddle_fixed failed on virt: no such board'
    ;;
tells_that_images_are_missing)
    bench 1 --run "$work/run" --images "$work/nowhere" --boards virt
    has_line "bench-firmware: there is no $work/nowhere/virt-O2/bin/bench_twiddle; make bench-firmware builds it"
    ;;
*) fail "no claim $3" ;;
esac

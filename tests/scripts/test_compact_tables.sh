#!/bin/sh
# test_compact_tables.sh SOURCE_DIR CASE: one claim about scripts/compact-tables, on made-up tables.
set -eu
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

write_tables() {
    cat >"$work/table1.csv" <<'END'
# made-up numbers
variant,object,model,centre,runs,mean_rad,sd_rad,best_rad,lower_rad,upper_rad,p,paper_reward
,ball,cpg-h,true,4,2.504,0.5,3,2,3,,5.692
,ball,cpg-h,false,4,3,0.25,3.5,2.5,3.5,0.0286,2.829
,ball,cpg-s,false,4,9,0,9,9,9,1,
slippery,ball,cpg-h,true,4,8,0,8,8,8,,
END
    cat >"$work/table2.csv" <<'END'
variant,object,model,centre,runs,mean_rad,sd_rad,best_rad,lower_rad,upper_rad,winner,p,p_holm,paper_mean,paper_sd,paper_best
,ball,cpg-s,true,4,1,0.01,1,1,1,false,0.1,0.2,3.981,0.018,3.993
,ball,cpg-h,true,4,2.504,0.5,3,2,3,true,,,5.686,0.063,5.773
slippery,ball,cpg-c,true,4,8,0,8,8,8,true,,,,,
END
}

case $2 in
prints_ours_the_papers_and_the_best_of_each_row)
    write_tables
    "$source/scripts/compact-tables" "$work" >"$work/printed"
    cat >"$work/expected" <<'END'
| object | CPG-H with centre | CPG-H without | p |
| --- | --- | --- | --- |
| ball | 2.50 ± 0.50 (5.692) | **3.00 ± 0.25 (2.829)** | 0.03 |

| object | CPG-S | CPG-M | CPG-C | CPG-H |
| --- | --- | --- | --- | --- |
| ball | 1.00 ± 0.01 (3.981) | - | - | **2.50 ± 0.50 (5.686)** |
END
    diff "$work/expected" "$work/printed" || fail 'another text'
    ;;
refuses_a_folder_without_tables)
    status=0
    "$source/scripts/compact-tables" "$work" >"$work/printed" 2>"$work/error" || status=$?
    [ "$status" -eq 2 ] || fail "exit status $status"
    grep -q 'no readable table1.csv' "$work/error" || fail "$(cat "$work/error")"
    ;;
*) fail "no case $2" ;;
esac

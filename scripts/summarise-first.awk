# summarise-first.awk: from the paper's two tables and one line a run (object,model,centre,mean rotation), the summary
# as CSV (for plots/first_results.gp) and as a Markdown table. Runs of one condition stand together, in the order to print.

BEGIN { FS = "," }
FNR == 1 { file++; header_seen = 0 }
/^#/ { next }
file < 3 && !header_seen { header_seen = 1; next }
file == 1 { table1[$1 "-" $2 "," $3] = $4; next }
file == 2 { object = $1 "-" $2 "," $3; mean2[object] = $4; sd2[object] = $5; best2[object] = $6; next }
{
    condition = $1 "," $2 "," $3
    if (!(condition in n)) order[++conditions] = condition
    rotation[condition, ++n[condition]] = $4
    sum[condition] += $4
    if (n[condition] == 1 || $4 > best[condition]) best[condition] = $4
}

# Standard deviation over the runs; empty for a single one.
function spread(condition,    i, mean, squares) {
    if (n[condition] < 2) return ""
    mean = sum[condition] / n[condition]
    for (i = 1; i <= n[condition]; i++) squares += (rotation[condition, i] - mean) ^ 2
    return sprintf("%.4f", sqrt(squares / (n[condition] - 1)))
}

function print_condition(condition,    part, with_centre, key, sd, first, second) {
    split(condition, part, ",")
    with_centre = part[3] == "true"
    key = part[1] "," part[2]
    sd = spread(condition)
    printf "%s,%d,%.4f,%s,%.4f,%s,%s,%s\n", condition, n[condition], sum[condition] / n[condition], sd, best[condition], \
        with_centre ? mean2[key] : table1[part[1] ",false"], with_centre ? sd2[key] : "", with_centre ? best2[key] : "" >csv
    first = part[2] == "cpg-h" ? table1[part[1] "," part[3]] : "-"
    second = with_centre ? mean2[key] " ± " sd2[key] " (" best2[key] ")" : "-"
    printf "| %s | %s | %.2f ± %s (%.2f) | %d | %s | %s |\n", part[1], toupper(part[2]) (with_centre ? "" : " without centre"), \
        sum[condition] / n[condition], sd == "" ? "-" : sprintf("%.2f", sd), best[condition], n[condition], second, first >markdown
}

END {
    print "# Mean rotation over the last " last " trials of each run: mean, standard deviation (n - 1) and best over n runs, in rad." >csv
    print "# Seeds " seeds ". The paper's rewards have no stated unit: Table 2, and Table 1 where centre is false." >csv
    print "object,model,centre,n,mean_rad,sd_rad,best_rad,paper_mean,paper_sd,paper_best" >csv
    print "| object | model | rotation (rad): mean ± sd (best) | runs | paper, Table 2 | paper, Table 1 |" >markdown
    print "| --- | --- | --- | --- | --- | --- |" >markdown
    for (c = 1; c <= conditions; c++) print_condition(order[c])
}

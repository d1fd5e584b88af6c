# made_up_sweep.awk: write the files of a summarized sweep with MADE-UP numbers, to test the figures with, but for the runs' own, and
# print "MODEL FOLDER" of each run. Nothing here was simulated.
# Use: awk -v folder=DIR -v objects="small-sphere ..." -v models="cpg-s ..." -v seeds=N -v trials=N -v variants="- slippery" \
#     -f made_up_sweep.awk, where `-` is the sweep's own settings; DIR/figures/data must exist.

function mean_of(o, m) { return 1 + 0.2 * o + 0.5 * m }

function spread_over_runs(sd) { return seeds == 1 ? "" : sd }

# With centre and without, each beside a value of the paper.
function write_tables(cell, mean,    sd, lower, upper) {
    sd = spread_over_runs(0.4)
    lower = spread_over_runs(mean - 0.3)
    upper = spread_over_runs(mean + 0.2)
    printf "%s,true,%d,%g,%s,%g,%s,%s,,5.5\n", cell, seeds, mean, sd, mean + 0.5, lower, upper >table1
    printf "%s,false,%d,%g,%s,%g,,,,2.5\n", cell, seeds, mean - 2, sd, mean - 1 >table1
    printf "%s,true,%d,%g,%s,%g,,,false,,,4.5,0.3,4.9\n", cell, seeds, mean, sd, mean + 0.5 >table2
}

function write_cell(variant, o, m,    prefix, cell, mean, where, trial, seed) {
    prefix = variant == "-" ? "" : variant
    cell = prefix "," object[o] "," model[m]
    mean = mean_of(o, m)
    write_tables(cell, mean)
    for (trial = 25.5; trial - 25.5 < trials; trial += 50)
        printf "%s,true,%d,%g,%g,%s,%g\n", cell, seeds, trial, mean * trial / trials, spread_over_runs(0.3), 1.1 * mean >curves
    for (seed = 1; seed <= seeds; seed++) {
        where = (prefix == "" ? "" : prefix "/") object[o] "/" model[m] "/seed-" seed
        if (seed <= 2) printf "%s,true,%d,%d,%s,%g\n", cell, seed, seed, where, mean >best
        print model[m], where
    }
}

BEGIN {
    table1 = folder "/table1.csv"
    table2 = folder "/table2.csv"
    curves = folder "/figures/data/learning_curves.csv"
    best = folder "/figures/data/best_runs.csv"
    printf "{\n  \"format\": 1,\n  \"sweep\": \"made-up\",\n  \"trials\": %d,\n  \"setup\": \"none\"\n}\n", trials >(folder "/sweep.json")
    cells = "variant,object,model,centre"
    print "# made-up numbers to test the figures with\n" cells ",runs,mean_rad,sd_rad,best_rad,lower_rad,upper_rad,p,paper_reward" >table1
    print cells ",runs,mean_rad,sd_rad,best_rad,lower_rad,upper_rad,winner,p,p_holm,paper_mean,paper_sd,paper_best" >table2
    print cells ",runs,trial,mean_rad,sd_rad,best_run_rad" >curves
    print cells ",rank,seed,folder,rotation_rad" >best
    variant_count = split(variants, variant, " ")
    object_count = split(objects, object, " ")
    model_count = split(models, model, " ")
    for (v = 1; v <= variant_count; v++)
        for (o = 1; o <= object_count; o++)
            for (m = 1; m <= model_count; m++) write_cell(variant[v], o, m)
}

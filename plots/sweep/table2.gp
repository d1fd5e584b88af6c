# table2.gp: the four models on each of the nine objects, beside the paper's Table 2.
# Reads SWEEP/table2.csv. Use: plots/draw-sweep SWEEP
width = 900
height = 830
folder = ARG0[:strlen(ARG0) - strlen('sweep/table2.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'
table = sweep . '/table2.csv'

here(object, model, shift) = of(object, models[model], 'true') ? model + shift : NaN

# One range for all panels: all that is drawn, and 0.
lowest = 0.0
highest = 0.1
do for [source in 'rad paper'] {
    mean = source eq 'rad' ? 'mean_rad' : 'paper_mean'
    sd = source eq 'rad' ? 'sd_rad' : 'paper_sd'
    best = source eq 'rad' ? 'best_rad' : 'paper_best'
    do for [bound = 1:3] {
        stats table using (!own('true') ? 0 : bound == 1 ? number(mean) - number(sd) : \
            bound == 2 ? number(mean) + number(sd) : number(best)) nooutput
        eval widen
    }
}
gap = 0.03 * (highest - lowest)

set multiplot title caption noenhanced
eval place_legend
set key maxrows 1 width 0 samplen 2
plot [0:1] [0:1] NaN with boxes fillstyle solid 1 noborder fillcolor rgb blue title 'twiddle (rad)', \
    NaN with boxes fillstyle solid 1 noborder fillcolor rgb light_orange title 'paper (reward, unit not stated)', \
    NaN with lines linecolor rgb black linewidth thin title 'mean ± sd over runs', \
    NaN with points pointtype 12 pointsize 0.8 linecolor rgb black title 'best run'
unset key

eval start_panels
set xrange [0.4:4.6]
set yrange [lowest < 0 ? lowest - gap : 0:highest + gap]
set boxwidth 0.36
set style fill solid 1 noborder
set grid noxtics
set style arrow 1 heads size screen 0.004, 90 linecolor rgb black linewidth thin
do for [size = 1:3] {
    do for [shape = 1:3] {
        eval place_panel
        set xtics ('' 1, '' 2, '' 3, '' 4) scale 0 textcolor rgb black
        if (size == 3) { set xtics ('S' 1, 'M' 2, 'C' 3, 'H' 4) }
        set format x '%g'
        set xlabel size == 3 ? 'CPG' : ''
        set ylabel shape == 1 ? 'rotation (rad); reward' : ''
        object = object_id(size, shape)
        there = 0
        do for [m = 1:4] {
            stats table using (of(object, models[m], 'true') ? 1 : 0) nooutput
            there = there + @found
            if (@found == 0) { set label m absent at first m, graph 0.03 left rotate textcolor rgb grey }
        }
        if (there == 0) {
            unset label
            eval say_absent
        } else {
            plot for [m = 1:4] table using (here(object, m, -0.2)):"mean_rad" with boxes fillcolor rgb blue, \
                for [m = 1:4] table using (here(object, m, 0.2)):"paper_mean" with boxes fillcolor rgb light_orange, \
                for [m = 1:4] table using (here(object, m, -0.2)):(column('mean_rad') - column('sd_rad')):(0):(2 * column('sd_rad')) \
                    with vectors arrowstyle 1, \
                for [m = 1:4] table using (here(object, m, 0.2)):(column('paper_mean') - column('paper_sd')):(0):(2 * column('paper_sd')) \
                    with vectors arrowstyle 1, \
                for [m = 1:4] table using (here(object, m, -0.2)):"best_rad" with points pointtype 12 pointsize 0.8 linecolor rgb black, \
                for [m = 1:4] table using (here(object, m, 0.2)):"paper_best" with points pointtype 12 pointsize 0.8 linecolor rgb black
        }
        unset label
    }
}
unset multiplot

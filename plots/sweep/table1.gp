# table1.gp: CPG-H with and without the parameters that set the centres of oscillation, beside the paper's Table 1.
# Reads SWEEP/table1.csv. Use: plots/draw-sweep SWEEP
width = 900
height = 430
folder = ARG0[:strlen(ARG0) - strlen('sweep/table1.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'
table = sweep . '/table1.csv'

# Places on the axis: for each shape, with centre and without.
place(shape, centre) = 3 * shape - 2 + (centre eq 'false')
here(size, shape, centre, shift) = of(object_id(size, shape), 'cpg-h', centre) ? place(shape, centre) + shift : NaN

# One range for all panels: all that is drawn, and 0.
lowest = 0.0
highest = 0.1
do for [name in 'mean_rad lower_rad upper_rad paper_reward'] {
    stats table using ((own('true') || own('false')) && strcol('model') eq 'cpg-h' ? number(name) : 0) nooutput
    eval widen
}
gap = 0.03 * (highest - lowest)

set multiplot title caption . "\nCPG-H with and without the parameters C that set the centres of oscillation" noenhanced
legend_y = 0.83
eval place_legend
set key maxrows 1 width -2
plot [0:1] [0:1] NaN with boxes fillstyle solid 1 noborder fillcolor rgb blue title 'twiddle (rad)', \
    NaN with lines linecolor rgb black linewidth thin title '95 % interval of the mean', \
    NaN with boxes fillstyle solid 1 noborder fillcolor rgb light_orange title 'paper (reward, unit not stated)'
unset key

eval start_panels
set bmargin at screen 0.17
set tmargin at screen 0.73
set xrange [0.3:8.7]
set yrange [lowest < 0 ? lowest - gap : 0:highest + gap]
set boxwidth 0.36
set style fill solid 1 noborder
set grid noxtics
set style arrow 1 heads size screen 0.004, 90 linecolor rgb black linewidth thin
do for [size = 1:3] {
    set lmargin at screen 0.075 + (size - 1) * 0.31
    set rmargin at screen 0.075 + (size - 1) * 0.31 + 0.29
    set title sizes[size] . ' objects'
    set ylabel size == 1 ? 'rotation (rad); reward' : ''
    set format y size == 1 ? '%g' : ''
    set xtics ('C' 1, 'no C' 2, 'C' 4, 'no C' 5, 'C' 7, 'no C' 8) scale 0 textcolor rgb black
    there = 0
    do for [shape = 1:3] {
        do for [centre in 'true false'] {
            stats table using (of(object_id(size, shape), 'cpg-h', centre) ? 1 : 0) nooutput
            there = there + @found
            if (@found == 0) {
                set label 10 * shape + (centre eq 'true') absent at first place(shape, centre), graph 0.03 left rotate textcolor rgb grey
            }
        }
        set label shape shapes[shape] at first 3 * shape - 1.5, screen 0.06 center
    }
    if (there == 0) {
        do for [shape = 1:3] { unset label 10 * shape; unset label 10 * shape + 1 }
        eval say_absent
    } else {
        plot for [shape = 1:3] for [centre in 'true false'] table \
                using (here(size, shape, centre, -0.2)):"mean_rad" with boxes fillcolor rgb blue, \
            for [shape = 1:3] for [centre in 'true false'] table \
                using (here(size, shape, centre, 0.2)):"paper_reward" with boxes fillcolor rgb light_orange, \
            for [shape = 1:3] for [centre in 'true false'] table \
                using (here(size, shape, centre, -0.2)):"lower_rad":(0):(column('upper_rad') - column('lower_rad')) \
                with vectors arrowstyle 1
    }
    unset label
}
unset multiplot

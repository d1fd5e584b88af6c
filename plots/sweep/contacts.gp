# contacts.gp: which finger pushes when, over one trial of what each model has learned on each object.
# Reads `contacts`, what contacts.awk makes of trajectory.csv of each model's best run. Use: plots/draw-sweep SWEEP
width = 900
height = 830
folder = ARG0[:strlen(ARG0) - strlen('sweep/contacts.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'

# From top to bottom CPG-S, -M, -C, -H, a band each: its upper half is the index's, its lower half the thumb's.
middle(model, finger) = 4 - model + (finger eq 'index' ? 0.7 : 0.3)
start_of(run, finger) = column('run') == run && strcol('finger') eq finger ? column('start_s') : NaN

set multiplot title caption . ', best run of each model' noenhanced
eval place_legend
set key maxrows 1 width 0
plot [0:1] [0:1] NaN with boxes fillstyle solid 1 noborder fillcolor rgb blue title 'index touches the object (upper bars)', \
    NaN with boxes fillstyle solid 1 noborder fillcolor rgb orange title 'thumb touches it (lower bars)'
unset key

eval start_panels
set xrange [0:3]
set xtics 0.5
set yrange [0:4]
set grid noytics
do for [size = 1:3] {
    do for [shape = 1:3] {
        eval place_panel
        set xlabel size == 3 ? 'time (s)' : ''
        set format y '%g'
        set ytics ('' 0) scale 0
        there = 0
        do for [m = 1:4] { there = there + has_run(size, shape, m, 1) }
        do for [m = 1:4] {
            if (shape == 1) { set ytics add (model_names[m] 4.5 - m) textcolor rgb black }
            if (there > 0 && m < 4) { set arrow m from graph 0, first m to graph 1, first m nohead linecolor rgb light_grey back }
            if (there > 0 && !has_run(size, shape, m, 1)) {
                set label m absent at graph 0.5, first 4.5 - m center textcolor rgb grey
            }
        }
        if (there == 0) {
            eval say_absent
        } else {
            plot for [m = 1:4] for [finger in 'index thumb'] contacts \
                using (start_of(100 * size + 10 * shape + m, finger)):(middle(m, finger)):"start_s":"end_s" \
                :(middle(m, finger) - 0.17):(middle(m, finger) + 0.17) with boxxyerror \
                fillstyle solid 1 noborder fillcolor rgb finger eq 'index' ? blue : orange
        }
        unset arrow
        unset label
    }
}
unset multiplot

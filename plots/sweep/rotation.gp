# rotation.gp: how far what each model has learned turns each object, over one trial.
# Reads trajectory.csv of each model's best run. Use: plots/draw-sweep SWEEP
width = 900
height = 830
folder = ARG0[:strlen(ARG0) - strlen('sweep/rotation.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'

# One range for all panels: all that is drawn, and 0.
lowest = 0.0
highest = 0.1
do for [size = 1:3] { do for [shape = 1:3] { do for [m = 1:4] {
    if (has_run(size, shape, m, 1)) {
        stats file_of(size, shape, m, 1, 'trajectory.csv') using (column('object_rad')) nooutput
        eval widen
    }
}}}
gap = 0.03 * (highest - lowest)

set multiplot title caption . ', best run of each model' noenhanced
eval place_legend
set key maxrows 1 width 2
plot [0:1] [0:1] for [m = 1:4] NaN with lines linecolor rgb model_colours[m] dashtype model_dashes[m] \
    linewidth model_widths[m] title model_names[m]
unset key

eval start_panels
set xrange [0:3]
set xtics 0.5
set yrange [lowest - gap:highest + gap]
do for [size = 1:3] {
    do for [shape = 1:3] {
        eval place_panel
        set xlabel size == 3 ? 'time (s)' : ''
        set ylabel shape == 1 ? 'rotation (rad)' : ''
        there = ''
        do for [m = 1:4] { if (has_run(size, shape, m, 1)) { there = there . ' ' . m } }
        if (there eq '') {
            eval say_absent
        } else {
            plot for [m in there] file_of(size, shape, int(m), 1, 'trajectory.csv') using "time_s":"object_rad" with lines \
                linecolor rgb model_colours[int(m)] dashtype model_dashes[int(m)] linewidth model_widths[int(m)]
        }
    }
}
unset multiplot

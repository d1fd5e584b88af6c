# fig6.gp: the driven joints over one trial of what each model has learned on one object (Fig. 6 of the paper): on the left the
# desired angles of all models, on the right CPG-H's, and the hand's.
# Reads trajectory.csv of each model's best run. Use: plots/draw-sweep SWEEP
width = 900
height = 900
folder = ARG0[:strlen(ARG0) - strlen('sweep/fig6.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'
size = example_size
shape = example_shape
trajectory(model) = file_of(size, shape, model, 1, 'trajectory.csv')

# Each panel spans its joint's whole range and a little more.
array joints[4] = ['fei', 'aai', 'fet', 'ot']
array short_names[4] = ['FEI', 'AAI', 'FET', 'OT']
array names[4] = ['index flexion', 'index adduction', 'thumb flexion', 'thumb opposition']
array lower_deg[4] = [0, -15, 0, 0]
array upper_deg[4] = [90, 15, 90, 130]
array step_deg[4] = [15, 5, 15, 30]
margin_deg(joint) = 0.05 * (upper_deg[joint] - lower_deg[joint])
angle_deg(kind, joint) = degrees(column(kind . '_' . joints[joint] . '_rad'))

# The models that there are, and their runs.
there = ''
whose = ''
do for [m = 1:4] {
    if (has_run(size, shape, m, 1)) {
        there = there . ' ' . m
        whose = whose . (whose eq '' ? '' : ', ') . model_names[m] . ' ' . seed_of(size, shape, m, 1)
    } else {
        model_names[m] = model_names[m] . ' (' . absent . ')'
    }
}

set multiplot title caption . "\n" . object_name(size, shape) . ', best runs: ' . whose noenhanced
legend_x = 0.30
legend_y = 0.927
eval place_legend
set key maxrows 1 samplen 2.5 width 1
plot [0:1] [0:1] for [m = 1:4] NaN with lines linecolor rgb model_colours[m] dashtype model_dashes[m] \
    linewidth model_widths[m] title model_names[m]
legend_x = 0.765
eval place_legend
plot [0:1] [0:1] NaN with lines linecolor rgb black linewidth thin dashtype dashed title 'desired', \
    NaN with lines linecolor rgb orange linewidth thick title 'actual'
unset key

eval start_panels
set xrange [0:3]
set xtics 0.5
do for [j = 1:4] {
    set bmargin at screen 0.065 + (4 - j) * 0.213
    set tmargin at screen 0.065 + (4 - j) * 0.213 + 0.175
    set yrange [lower_deg[j] - margin_deg(j):upper_deg[j] + margin_deg(j)]
    set ytics lower_deg[j], step_deg[j], upper_deg[j]
    set xlabel j == 4 ? 'time (s)' : ''
    set format x j == 4 ? '%g' : ''

    set lmargin at screen 0.085
    set rmargin at screen 0.515
    set format y '%g'
    set ylabel short_names[j] . ' (deg)'
    set title names[j] . ', desired'
    if (there eq '') {
        eval say_absent
    } else {
        plot for [m in there] trajectory(int(m)) using "time_s":(angle_deg('desired', j)) with lines \
                linecolor rgb model_colours[int(m)] dashtype model_dashes[int(m)] linewidth model_widths[int(m)], \
            lower_deg[j] with lines linecolor rgb grey linewidth thin dashtype dotted, \
            upper_deg[j] with lines linecolor rgb grey linewidth thin dashtype dotted
    }

    set lmargin at screen 0.55
    set rmargin at screen 0.98
    set format y ''
    set ylabel ''
    set title names[j] . ', CPG-H'
    if (!has_run(size, shape, 4, 1)) {
        eval say_absent
    } else {
        plot trajectory(4) using "time_s":(angle_deg('desired', j)) with lines linecolor rgb black linewidth thin dashtype dashed, \
            '' using "time_s":(angle_deg('actual', j)) with lines linecolor rgb orange linewidth thick, \
            lower_deg[j] with lines linecolor rgb grey linewidth thin dashtype dotted, \
            upper_deg[j] with lines linecolor rgb grey linewidth thin dashtype dotted
    }
}
unset multiplot

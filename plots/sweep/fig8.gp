# fig8.gp: how the two best runs of CPG-H on one object mix the three CPGs as they learn (Fig. 8 of the paper).
# Reads their trials.csv. Use: plots/draw-sweep SWEEP
width = 900
height = 420
folder = ARG0[:strlen(ARG0) - strlen('sweep/fig8.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'
size = example_size
shape = example_shape

# Of a long run, some trials are left out behind the means, to keep the SVG small.
stride = ceil(trials / 1000.0)
points_label = stride == 1 ? 'one trial' : sprintf('trials, 1 in %d', stride)

set multiplot title caption . "\n" . object_name(size, shape) . ', the two best runs of CPG-H' noenhanced
legend_y = 0.825
eval place_legend
set key maxrows 1 width -1
plot [0:1] [0:1] NaN with lines linecolor rgb blue linewidth thick title 'CPG-C', \
    NaN with lines linecolor rgb vermilion linewidth thick dashtype dashed title 'CPG-M', \
    NaN with lines linecolor rgb green linewidth thick dashtype dotted title 'CPG-S', \
    NaN with points pointtype 7 pointsize 0.5 linecolor rgb grey title points_label
unset key

eval start_panels
set bmargin at screen 0.15
set tmargin at screen 0.72
set xrange [0:trials]
set xtics tic_step(trials, 5)
set yrange [0:1]
set xlabel sprintf('trial (lines: running mean over the last %d)', window)
do for [rank = 1:2] {
    set lmargin at screen rank == 1 ? 0.08 : 0.55
    set rmargin at screen rank == 1 ? 0.495 : 0.965
    set ylabel rank == 1 ? 'selector weight' : ''
    set format y rank == 1 ? '%g' : ''
    set title rank == 1 ? 'best run' : 'second best run'
    if (!has_run(size, shape, 4, rank)) {
        eval say_absent
    } else {
        set title (rank == 1 ? 'best run: ' : 'second best run: ') . seed_of(size, shape, 4, rank) . ', ' . \
            rotation_of(size, shape, 4, rank) . ' at the end'
        run = file_of(size, shape, 4, rank, 'trials.csv')
        plot run using "trial":"s_c" every stride with points pointtype 7 pointsize 0.15 linecolor rgb light_blue, \
            '' using "trial":"s_m" every stride with points pointtype 7 pointsize 0.15 linecolor rgb light_vermilion, \
            '' using "trial":"s_s" every stride with points pointtype 7 pointsize 0.15 linecolor rgb light_green, \
            '' using "trial":(running_mean(column("s_c"), $0)) with lines linecolor rgb blue linewidth thick, \
            '' using "trial":(running_mean(column("s_m"), $0)) with lines linecolor rgb vermilion linewidth thick dashtype dashed, \
            '' using "trial":(running_mean(column("s_s"), $0)) with lines linecolor rgb green linewidth thick dashtype dotted
    }
}
unset multiplot

# selector_weights.gp: how CPG-H mixes its three CPGs as it learns (Fig. 8 of the paper).
# Reads RUN/trials.csv. Use: gnuplot -e "run='RUN'; output='FILE'; format='svg'" plots/selector_weights.gp
width = 800
height = 440
load ARG0[:strlen(ARG0) - strlen('selector_weights.gp')] . 'style.gp'
trials = run . '/trials.csv'

# Of a long run, some trials are left out behind the means, to keep the SVG small.
stats trials using (column("trial")) nooutput
stride = ceil(STATS_records / 1500.0)
points_label = stride == 1 ? 'one trial' : sprintf('trials, 1 in %d', stride)

set key width -3 # gnuplot takes these labels for wider than they are
set autoscale xfixmax
set multiplot layout 1, 1 title caption noenhanced margins 0.095, 0.965, 0.14, 0.855
set xlabel sprintf('trial (lines: running mean over the last %d trials)', window)
set ylabel 'selector weight'
set yrange [0:1]
plot trials using "trial":"s_c" every stride with points pointtype 7 pointsize 0.15 linecolor rgb light_blue notitle, \
    '' using "trial":"s_m" every stride with points pointtype 7 pointsize 0.15 linecolor rgb light_vermilion notitle, \
    '' using "trial":"s_s" every stride with points pointtype 7 pointsize 0.15 linecolor rgb light_green notitle, \
    '' using "trial":(running_mean(column("s_c"), $0)) with lines linecolor rgb blue linewidth thick title 'CPG-C', \
    '' using "trial":(running_mean(column("s_m"), $0)) with lines linecolor rgb vermilion linewidth thick dashtype dashed title 'CPG-M', \
    '' using "trial":(running_mean(column("s_s"), $0)) with lines linecolor rgb green linewidth thick dashtype dotted title 'CPG-S', \
    NaN with points pointtype 7 pointsize 0.5 linecolor rgb grey title points_label
unset multiplot

# learning_curve.gp: what a run learned: rotation of each trial above, what the critic expected below.
# Reads RUN/trials.csv. Use: gnuplot -e "run='RUN'; output='FILE'; format='svg'" plots/learning_curve.gp
width = 800
height = 620
load ARG0[:strlen(ARG0) - strlen('learning_curve.gp')] . 'style.gp'
trials = run . '/trials.csv'

# Fewer trials, larger points.
stats trials using (column("trial")) nooutput
point = STATS_records < 1500 ? 0.35 : 0.18

set key width -3 # gnuplot takes these labels for wider than they are
set autoscale xfixmax
set multiplot layout 2, 1 title caption noenhanced margins 0.095, 0.965, 0.1, 0.9 spacing 0.12

set ylabel 'rotation (rad)'
plot trials using "trial":"rotation_rad" with points pointtype 7 pointsize point linecolor rgb light_blue notitle, \
    NaN with points pointtype 7 pointsize 0.5 linecolor rgb light_blue title 'one trial', \
    '' using "trial":(running_mean(column("rotation_rad"), $0)) with lines linecolor rgb blue linewidth thick \
        title sprintf('running mean (last %d)', window)

set xlabel 'trial'
set ylabel 'reward'
plot trials using "trial":"value" with points pointtype 7 pointsize point linecolor rgb light_orange notitle, \
    NaN with points pointtype 7 pointsize 0.5 linecolor rgb orange title "critic's estimate", \
    '' using "trial":(running_mean(column("value"), $0)) with lines linecolor rgb vermilion linewidth 2 * thick \
        title 'its running mean', \
    '' using "trial":(running_mean(column("reward"), $0)) with lines linecolor rgb black linewidth thin dashtype dashed \
        title "reward's running mean"
unset multiplot

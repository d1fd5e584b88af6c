# first_results.gp: the first results beside the paper's Tables 1 and 2, three objects by five models.
# Reads the summary.csv of scripts/summarise-first; which runs that takes is said there.
# Use: gnuplot -e "summary='results/first/summary.csv'; output='FILE'; format='svg'" plots/first_results.gp
width = 900
height = 440
load ARG0[:strlen(ARG0) - strlen('first_results.gp')] . 'style.gp'

array objects[3] = ['small-sphere', 'medium-cylinder', 'large-cube']
# Place of a condition on the axis.
place(model, centre) = centre eq 'false' ? 5 : model eq 'cpg-s' ? 1 : model eq 'cpg-m' ? 2 : model eq 'cpg-c' ? 3 : 4
here(object, shift) = strcol('object') eq object ? place(strcol('model'), strcol('centre')) + shift : NaN
set datafile missing ''

# One range for all panels.
highest = 6.0 # the paper's
lowest = 0.0
do for [sign in "-1 0 1"] {
    stats summary using (column('mean_rad') + (sign == 0 ? 0 : sign * column('sd_rad'))) nooutput
    if (STATS_max > highest) { highest = STATS_max }
    if (STATS_min < lowest) { lowest = STATS_min }
}
stats summary using (column('best_rad')) nooutput
if (STATS_max > highest) { highest = STATS_max }

set multiplot layout 1, 3 title caption noenhanced margins 0.075, 0.985, 0.2, 0.82 spacing 0.03
set xrange [0.4:5.6]
set yrange [1.05 * lowest:1.05 * highest]
set boxwidth 0.36
set style fill solid 1 noborder
set xtics ('S' 1, 'M' 2, 'C' 3, 'H' 4, "H, no\ncentre" 5) scale 0
set grid noxtics
set xlabel offset 0, -0.7
set style arrow 1 heads size 0.09, 90 linecolor rgb black linewidth thin
do for [o = 1:3] {
    set title objects[o]
    set ylabel o == 1 ? 'rotation (rad); paper: reward, unit not stated' : ''
    set format y o == 1 ? '%g' : ''
    set xlabel o == 2 ? 'CPG (bar: mean over runs, whisker: standard deviation)' : ''
    if (o == 2) { set key at screen 0.54, 0.945 center center samplen 1.5 } else { unset key }
    plot summary using (here(objects[o], -0.2)):"mean_rad" with boxes linecolor rgb blue title 'twiddle', \
        '' using (here(objects[o], 0.2)):"paper_mean" with boxes linecolor rgb light_orange title 'paper', \
        '' using (here(objects[o], -0.2)):(column('mean_rad') - column('sd_rad')):(0):(2 * column('sd_rad')) with vectors arrowstyle 1 notitle, \
        '' using (here(objects[o], 0.2)):(column('paper_mean') - column('paper_sd')):(0):(2 * column('paper_sd')) with vectors arrowstyle 1 notitle, \
        '' using (here(objects[o], -0.2)):"best_rad" with points pointtype 12 pointsize 0.8 linecolor rgb black title 'best run', \
        '' using (here(objects[o], 0.2)):"paper_best" with points pointtype 12 pointsize 0.8 linecolor rgb black notitle
}
unset multiplot

# performance.gp: control steps a second as the work grows: substeps, fingers in contact, objects, workers.
# Reads the CSV of bench_growth, whose `#` lines say what was measured and how.
# Use: gnuplot -e "growth='docs/results/performance.csv'; output='FILE'; format='svg'" plots/performance.gp
width = 900
height = 760
load ARG0[:strlen(ARG0) - strlen('performance.gp')] . 'style.gp'
if (caption eq '') { caption = 'Speed of the full loop: controller, torques at every substep, world' }

array objects[3] = ['small-sphere', 'medium-cylinder', 'large-cube']
array shapes[3] = ['sphere', 'cylinder', 'cube']
array colours[3] = [blue, orange, green] # of different lightness too, for grey print
array markers[3] = [7, 5, 9]             # filled; the open ones come one before

thousands(name) = column(name) / 1000
is_of(series, quantity) = strcol('series') eq series && strcol('quantity') eq quantity
# `value` in rows of this series, stepper and object; nothing in others.
of_curve(series, stepper, object, value) = is_of(series, 'control_steps_per_s') && strcol('stepper') eq stepper && \
    strcol('object') eq object ? value : NaN
set datafile missing NaN # lines go on over other rows

set multiplot layout 2, 2 title caption noenhanced margins 0.085, 0.985, 0.075, 0.86 spacing 0.085, 0.16

set title 'By substeps of a 10 ms control step, one core'
set logscale xy
set xrange [1.8:115]
set yrange [1:2000]
set xtics (2, 3, 5, 10, 20, 50, 100)
set xlabel 'substeps'
set ylabel 'thousand control steps a second'
set key at screen 0.5, 0.932 center center vertical maxrows 1 samplen 2.5
set label 1 'fast' at 45, 95 center
set label 2 'reference' at 8, 5 center
plot for [o = 1:3] growth using (of_curve('substeps', 'fast', objects[o], column('substeps'))):(thousands('median')) \
        with linespoints linecolor rgb colours[o] linewidth thick pointtype markers[o] title objects[o], \
    for [o = 1:3] '' using (of_curve('substeps', 'reference', objects[o], column('substeps'))):(thousands('median')) \
        with linespoints linecolor rgb colours[o] linewidth thin dashtype dashed pointtype markers[o] - 1 notitle
unset logscale
unset label
unset key
unset ylabel

# Bars side by side, a shape each, from 0; whiskers from the least to the most of the repeats.
set xrange [*:*]
set boxwidth 0.25
set style fill solid 1 noborder
set style arrow 1 heads size graph 0.008, 90 linecolor rgb black linewidth thin
set grid noxtics
set ytics 200
beside(place, o) = place + 0.28 * (o - 2)
fingers_bar(o) = of_curve('fingers', 'fast', objects[o], beside(column('fingers'), o))
workers_bar(o) = of_curve('workers', 'fast', objects[o], beside(log(column('workers')) / log(2), o))
size_place(object) = object[:5] eq 'small' ? 0 : object[:6] eq 'medium' ? 1 : 2
is_shape(object, shape) = strlen(object) > strlen(shape) && object[strlen(object) - strlen(shape) + 1:] eq shape
objects_bar(o) = is_of('objects', 'control_steps_per_s') && is_shape(strcol('object'), shapes[o]) ? \
    beside(size_place(strcol('object')), o) : NaN

set yrange [0:*]
set xrange [-0.6:2.6]
set xtics ('none' 0, 'one' 1, 'both' 2) scale 0
set xlabel 'fingers at rest against the object (none: out of reach)'
set title 'By fingers in contact: fast, 5 substeps, one core'
plot for [o = 1:3] growth using (fingers_bar(o)):(thousands('median')) with boxes linecolor rgb colours[o], \
    for [o = 1:3] '' using (fingers_bar(o)):(thousands('least')):(0):(thousands('most') - thousands('least')) \
        with vectors arrowstyle 1

set xtics ('small' 0, 'medium' 1, 'large' 2)
set xlabel 'size of the object; the colours are of its shape'
set ylabel 'thousand control steps a second'
set title 'By object: fast, 5 substeps, one core'
plot for [o = 1:3] growth using (objects_bar(o)):(thousands('median')) with boxes linecolor rgb colours[o], \
    for [o = 1:3] '' using (objects_bar(o)):(thousands('least')):(0):(thousands('most') - thousands('least')) \
        with vectors arrowstyle 1
unset ylabel

# Above a bar: the ratio to one worker, which the file has beside the speed.
stats growth using (is_of('workers', 'control_steps_per_s') ? column('workers') : NaN) nooutput
set xrange [-0.6:log(STATS_max) / log(2) + 0.6]
stats growth using (is_of('workers', 'control_steps_per_s') ? thousands('most') : NaN) nooutput
set yrange [0:1.15 * STATS_max]
set xtics ('1' 0, '2' 1, '4' 2, '8' 3, '16' 4, '32' 5, '64' 6, '128' 7)
set xlabel 'workers (above the bars: ratio to one worker)'
set title 'By workers, all together: fast, 5 substeps'
last_most = 0
with_ratio(o) = is_of('workers', 'control_steps_per_s') ? (last_most = thousands('most'), NaN) : \
    is_of('workers', 'ratio_to_one_worker') && strcol('object') eq objects[o] && column('workers') > 1 ? last_most : NaN
plot for [o = 1:3] growth using (workers_bar(o)):(thousands('median')) with boxes linecolor rgb colours[o], \
    for [o = 1:3] '' using (workers_bar(o)):(thousands('least')):(0):(thousands('most') - thousands('least')) \
        with vectors arrowstyle 1, \
    for [o = 1:3] '' using (beside(log(column('workers')) / log(2), o)):(with_ratio(o)): \
        (sprintf('%.2f', column('median'))) with labels offset 0, 0.7
unset multiplot

# fig7.gp: where the fingertips of CPG-H and of CPG-C go around the object in one trial of what they have learned (Fig. 7 of the
# paper): above in space, below seen along the hinge.
# Reads trajectory.csv and object_outline.csv of their best runs; palm frame: +x distal, +y ulnar, +z out of the palm.
# Use: plots/draw-sweep SWEEP
width = 900
height = 900
folder = ARG0[:strlen(ARG0) - strlen('sweep/fig7.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'
size = example_size
shape = example_shape
array drawn[2] = [4, 3] # CPG-H on the left, CPG-C on the right
trajectory(model) = file_of(size, shape, model, 1, 'trajectory.csv')
outline(model) = file_of(size, shape, model, 1, 'object_outline.csv')

array axes[3] = ['x', 'y', 'z']
coordinate(part, a) = millimetres(column(part . axes[a] . '_m'))

# Ranges in mm: all that is drawn on either side, to the next multiple of 20 mm.
array lower[3]
array upper[3]
do for [a = 1:3] {
    lower[a] = 0
    upper[a] = 20
    do for [side = 1:2] {
        m = drawn[side]
        if (has_run(size, shape, m, 1)) {
            stats outline(m) using (coordinate('', a)) nooutput
            polylines = STATS_blank + 1
            if (STATS_min < lower[a]) { lower[a] = STATS_min }
            if (STATS_max > upper[a]) { upper[a] = STATS_max }
            do for [part in "index_ thumb_"] {
                stats trajectory(m) using (coordinate(part, a)) nooutput
                if (exists('STATS_min')) { # not after a fault in the first step
                    if (STATS_min < lower[a]) { lower[a] = STATS_min }
                    if (STATS_max > upper[a]) { upper[a] = STATS_max }
                }
            }
        }
    }
    lower[a] = 20 * floor((lower[a] - 2) / 20)
    upper[a] = 20 * ceil((upper[a] + 2) / 20)
}
span(a) = upper[a] - lower[a]

whose = ''
do for [side = 1:2] {
    m = drawn[side]
    if (has_run(size, shape, m, 1)) {
        whose = whose . (whose eq '' ? '' : ', ') . model_names[m] . ' ' . seed_of(size, shape, m, 1)
    }
}

set multiplot title caption . "\n" . object_name(size, shape) . ', best runs: ' . whose . ' (a mark every 0.1 s, a large one at the start)' noenhanced
legend_y = 0.93
eval place_legend
set key maxrows 1 width 1
plot [0:1] [0:1] NaN with lines linecolor rgb grey linewidth thin title 'object', \
    for [part in "index thumb"] NaN with linespoints linecolor rgb part eq 'index' ? blue : vermilion linewidth thin \
        pointtype part eq 'index' ? 7 : 5 pointsize 0.35 title part . ' tip'
unset key

# One scale for both views along the hinge, as large as the room for them allows.
room_x = 0.38 * width
room_y = 0.36 * height
scale = room_x / span(1) < room_y / span(2) ? room_x / span(1) : room_y / span(2)
center_x(side) = side == 1 ? 0.29 : 0.77
do for [side = 1:2] {
    m = drawn[side]
    eval start_panels
    set lmargin at screen center_x(side) - 0.5 * scale * span(1) / width
    set rmargin at screen center_x(side) + 0.5 * scale * span(1) / width
    set bmargin at screen 0.075
    set tmargin at screen 0.075 + scale * span(2) / height
    set xrange [lower[1]:upper[1]]
    set yrange [lower[2]:upper[2]]
    set xtics 20
    set ytics 20
    set title model_names[m] . ' along the hinge, onto the palm' offset 0, 0
    set xlabel 'x, distal (mm)' offset 0, 0.3
    set ylabel side == 1 ? 'y, ulnar (mm)' : '' offset 0, 0
    if (!has_run(size, shape, m, 1)) {
        eval say_absent
    } else {
        plot outline(m) using (coordinate('', 1)):(coordinate('', 2)) with lines linecolor rgb grey linewidth thin, \
            for [part in "index_ thumb_"] trajectory(m) using (coordinate(part, 1)):(coordinate(part, 2)) with linespoints \
                pointtype part eq 'index_' ? 7 : 5 pointsize 0.35 pointinterval 10 \
                linecolor rgb part eq 'index_' ? blue : vermilion linewidth thin, \
            for [part in "index_ thumb_"] trajectory(m) using (coordinate(part, 1)):(coordinate(part, 2)) every ::0::0 \
                with points pointtype part eq 'index_' ? 7 : 5 pointsize 0.9 linecolor rgb part eq 'index_' ? blue : vermilion
    }
}

# In space; each polyline by itself, since gnuplot would join those of one length into a mesh.
set view equal xyz
set view 60, 50, 1.2
set xyplane at lower[3]
set border 31
set grid
set xtics 40 offset 0, -0.3
set ytics 40 offset 0, -0.3
set ztics 40
set format '%g'
set zrange [lower[3]:upper[3]]
set xlabel 'x (mm)' offset 0, -0.5
set ylabel 'y (mm)' offset 0, -0.5
set label 1 'z (mm)' at lower[1], lower[2], upper[3] + 12 center
set bmargin at screen 0.53
set tmargin at screen 0.88
do for [side = 1:2] {
    m = drawn[side]
    set lmargin at screen center_x(side) - 0.21
    set rmargin at screen center_x(side) + 0.21
    set title model_names[m] . ' in space' offset 0, 0
    if (has_run(size, shape, m, 1)) {
        splot for [b = 0:polylines - 1] outline(m) using (coordinate('', 1)):(coordinate('', 2)):(coordinate('', 3)) \
                every :::b::b with lines linecolor rgb grey linewidth thin, \
            for [part in "index_ thumb_"] trajectory(m) \
                using (coordinate(part, 1)):(coordinate(part, 2)):(coordinate(part, 3)) with linespoints \
                pointtype part eq 'index_' ? 7 : 5 pointsize 0.35 pointinterval 10 \
                linecolor rgb part eq 'index_' ? blue : vermilion linewidth thin, \
            for [part in "index_ thumb_"] trajectory(m) \
                using (coordinate(part, 1)):(coordinate(part, 2)):(coordinate(part, 3)) every ::0::0 with points \
                pointtype part eq 'index_' ? 7 : 5 pointsize 0.9 linecolor rgb part eq 'index_' ? blue : vermilion
    }
}
unset multiplot

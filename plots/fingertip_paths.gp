# fingertip_paths.gp: where the two fingertips go in one trial, around the object (Fig. 7 of the paper).
# Three projections that share their axes and their scale, and a view in space.
# Reads RUN/trajectory.csv and RUN/object_outline.csv; palm frame: +x distal, +y ulnar, +z out of the palm.
# Use: gnuplot -e "run='RUN'; output='FILE'; format='svg'" plots/fingertip_paths.gp
width = 800
height = 860
load ARG0[:strlen(ARG0) - strlen('fingertip_paths.gp')] . 'style.gp'
trajectory = run . '/trajectory.csv'
outline = run . '/object_outline.csv'

array axes[3] = ['x', 'y', 'z']
array labels[3] = ['x, distal (mm)', 'y, ulnar (mm)', 'z, out of the palm (mm)']
coordinate(part, a) = millimetres(column(part . axes[a] . '_m'))

# Ranges in mm: all that is drawn, to the next multiple of 20 mm.
array lower[3]
array upper[3]
do for [a = 1:3] {
    stats outline using (coordinate('', a)) nooutput
    polylines = STATS_blank + 1
    lower[a] = STATS_min
    upper[a] = STATS_max
    do for [part in "index_ thumb_"] {
        stats trajectory using (coordinate(part, a)) nooutput
        if (STATS_min < lower[a]) { lower[a] = STATS_min }
        if (STATS_max > upper[a]) { upper[a] = STATS_max }
    }
    lower[a] = 20 * floor((lower[a] - 2) / 20)
    upper[a] = 20 * ceil((upper[a] + 2) / 20)
}
span(a) = upper[a] - lower[a]

# The figure's plan in pixels: z|y over x, one scale for all three.
left = 75.0
bottom = 65.0
gap_x = 90.0
gap_y = 90.0
top = 95.0
right = 25.0
scale_x = (width - left - gap_x - right) / (span(1) + span(3))
scale_y = (height - bottom - gap_y - top) / (span(2) + span(3))
scale = scale_x < scale_y ? scale_x : scale_y
column_2 = left + scale * span(1) + gap_x
row_2 = bottom + scale * span(3) + gap_y

set multiplot title caption noenhanced

# The legend, in a panel of its own that is wide enough.
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0.92
set tmargin at screen 0.97
set key at screen 0.5, 0.945 center center width -3
unset border
unset xtics
unset ytics
plot [0:1] [0:1] NaN with lines linecolor rgb grey linewidth thin title 'object', \
    NaN with linespoints linecolor rgb blue linewidth thin pointtype 7 pointsize 0.35 title 'index tip', \
    NaN with points pointtype 7 linecolor rgb blue title 'its start', \
    NaN with linespoints linecolor rgb vermilion linewidth thin pointtype 5 pointsize 0.35 title 'thumb tip', \
    NaN with points pointtype 5 linecolor rgb vermilion title 'its start'

unset key
set border 3
set xtics 20 nomirror out scale 0.6 textcolor rgb black
set ytics 20 nomirror out scale 0.6 textcolor rgb black
array across[3] = [1, 1, 3]
array up[3] = [3, 2, 2]
array names[3] = ['from the side', 'along the hinge, onto the palm (a mark every 0.1 s)', 'along the fingers']
do for [panel = 1:3] {
    h = across[panel]
    v = up[panel]
    x0 = panel == 3 ? column_2 : left
    y0 = panel == 1 ? bottom : row_2
    set lmargin at screen x0 / width
    set rmargin at screen (x0 + scale * span(h)) / width
    set bmargin at screen y0 / height
    set tmargin at screen (y0 + scale * span(v)) / height
    set xrange [lower[h]:upper[h]]
    set yrange [lower[v]:upper[v]]
    set title names[panel]
    set xlabel labels[h]
    set ylabel labels[v]
    plot outline using (coordinate('', h)):(coordinate('', v)) with lines linecolor rgb grey linewidth thin, \
        trajectory using (coordinate('index_', h)):(coordinate('index_', v)) with linespoints \
            pointtype 7 pointsize 0.35 pointinterval 10 linecolor rgb blue linewidth thin, \
        '' using (coordinate('thumb_', h)):(coordinate('thumb_', v)) with linespoints \
            pointtype 5 pointsize 0.35 pointinterval 10 linecolor rgb vermilion linewidth thin, \
        '' using (coordinate('index_', h)):(coordinate('index_', v)) every ::0::0 with points \
            pointtype 7 pointsize 0.9 linecolor rgb blue, \
        '' using (coordinate('thumb_', h)):(coordinate('thumb_', v)) every ::0::0 with points \
            pointtype 5 pointsize 0.9 linecolor rgb vermilion
}

# In space; each polyline by itself, since gnuplot would join those of one length into a mesh.
set lmargin at screen (column_2 - 30) / width
set rmargin at screen (width - 10.0) / width
set bmargin at screen bottom / height
set tmargin at screen (row_2 - gap_y) / height
set view equal xyz
set view 60, 50, 0.8
set xyplane at lower[3]
set border 31
set xtics 40 offset 0, -0.3
set ytics 40 offset 0, -0.3
set ztics 40
set xrange [lower[1]:upper[1]]
set yrange [lower[2]:upper[2]]
set zrange [lower[3]:upper[3]]
set title 'in space (mm)' offset 0, 1
set xlabel 'x' offset 0, -0.5
set ylabel 'y' offset 0, -0.5
set label 'z' at lower[1], lower[2], upper[3] + 12 center
splot for [b = 0:polylines - 1] outline using (coordinate('', 1)):(coordinate('', 2)):(coordinate('', 3)) every :::b::b \
        with lines linecolor rgb grey linewidth thin, \
    trajectory using (coordinate('index_', 1)):(coordinate('index_', 2)):(coordinate('index_', 3)) with lines \
        linecolor rgb blue linewidth thin, \
    '' using (coordinate('thumb_', 1)):(coordinate('thumb_', 2)):(coordinate('thumb_', 3)) with lines \
        linecolor rgb vermilion linewidth thin, \
    '' using (coordinate('index_', 1)):(coordinate('index_', 2)):(coordinate('index_', 3)) every ::0::0 with points \
        pointtype 7 pointsize 0.9 linecolor rgb blue, \
    '' using (coordinate('thumb_', 1)):(coordinate('thumb_', 2)):(coordinate('thumb_', 3)) every ::0::0 with points \
        pointtype 5 pointsize 0.9 linecolor rgb vermilion
unset multiplot

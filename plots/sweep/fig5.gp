# fig5.gp: how the four models learn on each of the nine objects (Fig. 5 of the paper).
# Reads SWEEP/figures/data/learning_curves.csv. Use: plots/draw-sweep SWEEP
width = 900
height = 830
folder = ARG0[:strlen(ARG0) - strlen('sweep/fig5.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'
curves = sweep . '/figures/data/learning_curves.csv'
set datafile missing ''

mean_of(object, model) = of(object, model, 'true') ? column('mean_rad') : NaN

# One range for all panels: all that is drawn, and 0.
lowest = 0.0
highest = 0.1
do for [bound = 1:4] {
    stats curves using (!own('true') ? 0 : bound == 1 ? column('mean_rad') - column('sd_rad') : \
        bound == 2 ? column('mean_rad') + column('sd_rad') : bound == 3 ? column('mean_rad') : \
        strcol('model') eq 'cpg-h' ? column('best_run_rad') : 0) nooutput
    if (STATS_records > 0) {
        if (STATS_min < lowest) { lowest = STATS_min }
        if (STATS_max > highest) { highest = STATS_max }
    }
}
stats curves using (column('trial')) nooutput
last_trial = STATS_max
gap = 0.03 * (highest - lowest)

set multiplot title caption noenhanced
left = 0.075
bottom = 0.075
panel_width = 0.283
panel_height = 0.243

# The legend, in a panel of its own.
unset border
unset xtics
unset ytics
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0.9
set tmargin at screen 0.96
set key at screen 0.5, 0.935 center center width 0 maxrows 2
plot [0:1] [0:1] for [m = 1:4] NaN with lines linecolor rgb model_colours[m] dashtype model_dashes[m] \
        linewidth model_widths[m] title model_names[m], \
    NaN with lines linecolor rgb orange linewidth thin title 'CPG-H, best run', \
    NaN with boxes fillstyle solid 1 noborder fillcolor rgb light_grey title 'mean ± sd over runs'
unset key

set border 3
set xtics nomirror out scale 0.6 textcolor rgb black
set ytics nomirror out scale 0.6 textcolor rgb black
set xrange [0:last_trial]
set yrange [lowest - gap:highest + gap]
do for [size = 1:3] {
    do for [shape = 1:3] {
        object = object_id(size, shape)
        x0 = left + (shape - 1) * (panel_width + 0.03)
        y0 = bottom + (3 - size) * (panel_height + 0.045)
        set lmargin at screen x0
        set rmargin at screen x0 + panel_width
        set bmargin at screen y0
        set tmargin at screen y0 + panel_height
        set title object_name(size, shape)
        set xlabel size == 3 ? 'trial' : ''
        set format x size == 3 ? '%g' : ''
        set ylabel shape == 1 ? 'rotation (rad)' : ''
        set format y shape == 1 ? '%g' : ''
        stats curves using (own('true') && strcol('object') eq object ? 1 : 0) nooutput
        if (STATS_sum == 0) { set label 1 absent at graph 0.5, 0.5 center textcolor rgb grey }
        plot for [m = 1:4] curves \
                using (column('trial')):(mean_of(object, models[m]) - column('sd_rad')):(mean_of(object, models[m]) + column('sd_rad')) \
                with filledcurves fillstyle transparent solid 0.2 noborder fillcolor rgb model_colours[m], \
            curves using (column('trial')):(of(object, 'cpg-h', 'true') ? column('best_run_rad') : NaN) with lines \
                linecolor rgb orange linewidth thin, \
            for [m = 1:4] curves using (column('trial')):(mean_of(object, models[m])) with lines \
                linecolor rgb model_colours[m] dashtype model_dashes[m] linewidth model_widths[m]
        unset label 1
    }
}
unset multiplot

# fig5.gp: how the four models learn on each of the nine objects (Fig. 5 of the paper).
# Reads SWEEP/figures/data/learning_curves.csv. Use: plots/draw-sweep SWEEP
width = 900
height = 830
folder = ARG0[:strlen(ARG0) - strlen('sweep/fig5.gp')]
load folder . 'style.gp'
load folder . 'sweep/cells.gp'
curves = sweep . '/figures/data/learning_curves.csv'

mean_of(object, model) = of(object, model, 'true') ? column('mean_rad') : NaN
low_of(object, model) = mean_of(object, model) - column('sd_rad')
high_of(object, model) = mean_of(object, model) + column('sd_rad')

# One range for all panels: all that is drawn, and 0.
lowest = 0.0
highest = 0.1
do for [bound = 1:3] {
    stats curves using (!own('true') ? 0 : bound == 1 ? column('mean_rad') - number('sd_rad') : \
        bound == 2 ? column('mean_rad') + number('sd_rad') : \
        strcol('model') eq 'cpg-h' ? column('best_run_rad') : 0) nooutput
    eval widen
}
gap = 0.03 * (highest - lowest)

set multiplot title caption noenhanced
eval place_legend
set key maxrows 2 width 0
plot [0:1] [0:1] for [m = 1:4] NaN with lines linecolor rgb model_colours[m] dashtype model_dashes[m] \
        linewidth model_widths[m] title model_names[m], \
    NaN with lines linecolor rgb black dashtype dash_dotted linewidth thin title 'CPG-H, best run', \
    NaN with boxes fillstyle solid 1 noborder fillcolor rgb light_grey title 'mean ± sd over runs'
unset key

eval start_panels
set xrange [0:trials]
set xtics tic_step(trials, 4)
set yrange [lowest - gap:highest + gap]
do for [size = 1:3] {
    do for [shape = 1:3] {
        eval place_panel
        set xlabel size == 3 ? 'trial' : ''
        set ylabel shape == 1 ? 'rotation (rad)' : ''
        object = object_id(size, shape)
        stats curves using (own('true') && strcol('object') eq object ? 1 : 0) nooutput
        if (@found == 0) {
            eval say_absent
        } else {
            plot for [m = 1:4] curves using "trial":(low_of(object, models[m])):(high_of(object, models[m])) \
                    with filledcurves fillstyle transparent solid 0.2 noborder fillcolor rgb model_colours[m], \
                for [m = 1:4] curves using "trial":(mean_of(object, models[m])) with lines \
                    linecolor rgb model_colours[m] dashtype model_dashes[m] linewidth model_widths[m], \
                curves using "trial":(of(object, 'cpg-h', 'true') ? column('best_run_rad') : NaN) with lines \
                    linecolor rgb black dashtype dash_dotted linewidth thin
        }
    }
}
unset multiplot

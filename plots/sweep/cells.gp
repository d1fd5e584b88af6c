# cells.gp: what the figures of a sweep share: the paper's objects and models, in its order, and where their best runs are.
#
# Taken from the command line beside style.gp's: `sweep`, the sweep's folder; `runs`, a file that draw-sweep writes: for each run
# to draw, folder_SOM_R, seed_SOM_R and rotation_SOM_R, where S, O and M count sizes, shapes and models below and R is the rank in
# figures/data/best_runs.csv; and example_size, example_shape: the object of the figures of one object. `trials`: of a run.
load runs

array sizes[3] = ['small', 'medium', 'large'] # the rows of the paper's tables
array shapes[3] = ['sphere', 'cylinder', 'cube'] # and their columns
array models[4] = ['cpg-s', 'cpg-m', 'cpg-c', 'cpg-h']
array model_names[4] = ['CPG-S', 'CPG-M', 'CPG-C', 'CPG-H']
array model_colours[4] = [green, vermilion, blue, black]
array model_dashes[4] = [dotted, dashed, 1, 1]
array model_widths[4] = [thick, thin, thin, thick]

object_id(size, shape) = sizes[size] . '-' . shapes[shape]
object_name(size, shape) = sizes[size] . ' ' . shapes[shape]

# Whether a row of a table is of the sweep's own settings and of this object, model and condition.
own(centre) = strcol('variant') eq '' && strcol('centre') eq centre
of(object, model, centre) = own(centre) && strcol('object') eq object && strcol('model') eq model

# A number in a row, 0 where there is none; after `stats`, how many rows were 1; and how to widen lowest..highest by what it found.
# It may have found nothing, in a table without rows.
number(name) = strcol(name) eq '' ? 0 : column(name)
found = "(exists('STATS_sum') ? STATS_sum : 0)"
widen = "if (exists('STATS_max')) { lowest = STATS_min < lowest ? STATS_min : lowest; highest = STATS_max > highest ? STATS_max : highest }"

# Where the run with this rank is, and what there is to say of it.
run_key(size, shape, model, rank) = sprintf('%d%d%d_%d', size, shape, model, rank)
has_run(size, shape, model, rank) = exists('folder_' . run_key(size, shape, model, rank))
file_of(size, shape, model, rank, name) = \
    sweep . '/' . value('folder_' . run_key(size, shape, model, rank)) . '/' . name
seed_of(size, shape, model, rank) = 'seed ' . value('seed_' . run_key(size, shape, model, rank))
rotation_of(size, shape, model, rank) = value('rotation_' . run_key(size, shape, model, rank)) . ' rad'

# A panel that has nothing to show; its ranges must be set.
absent = 'not in this sweep'
say_absent = "set label 99 absent at graph 0.5, 0.5 center textcolor rgb grey; plot NaN notitle; unset label 99"

# Nine panels, one an object, in a figure 900 wide and 830 high: `eval start_panels`, then `eval place_panel` with `size` and `shape`
# set.
panel_left(shape) = 0.075 + (shape - 1) * 0.308
panel_bottom(size) = 0.07 + (3 - size) * 0.287
panel_width = 0.275
panel_height = 0.24
start_panels = "set border 3; set xtics nomirror out scale 0.6 textcolor rgb black; \
    set ytics nomirror out scale 0.6 textcolor rgb black"
place_panel = "set lmargin at screen panel_left(shape); set rmargin at screen panel_left(shape) + panel_width; \
    set bmargin at screen panel_bottom(size); set tmargin at screen panel_bottom(size) + panel_height; \
    set title object_name(size, shape); set format x size == 3 ? '%g' : ''; set format y shape == 1 ? '%g' : ''"

# The legend above panels, in a strip of its own: `eval place_legend`, then a plot of NaN with titles.
legend_x = 0.5
legend_y = 0.947
place_legend = "unset border; unset xtics; unset ytics; set lmargin at screen 0; set rmargin at screen 1; \
    set bmargin at screen legend_y - 0.03; set tmargin at screen legend_y + 0.03; \
    set key at screen legend_x, legend_y center center"

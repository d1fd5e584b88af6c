# cells.gp: what the figures of a sweep share: the paper's objects and models, in its order, and where their best runs are.
#
# Taken from the command line beside style.gp's: `sweep`, the sweep's folder; `runs`, a file that draw-sweep writes: for each run
# to draw, run_SOM_R = folder below the sweep's and about_SOM_R = what to say of it, where S, O and M count sizes, shapes and
# models below and R is the rank in figures/data/best_runs.csv.
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

run_key(size, shape, model, rank) = sprintf('%d%d%d_%d', size, shape, model, rank)
has_run(size, shape, model, rank) = exists('run_' . run_key(size, shape, model, rank))
file_of(size, shape, model, rank, name) = sweep . '/' . value('run_' . run_key(size, shape, model, rank)) . '/' . name
about(size, shape, model, rank) = value('about_' . run_key(size, shape, model, rank))

# A panel that has nothing to show.
absent = 'not in this sweep'

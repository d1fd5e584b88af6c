# style.gp: the one look of all figures. A figure's script sets `width` and `height` and loads this file first.
#
# Taken from the command line (gnuplot -e): `output`, the file to write; `format`, svg (default) or png;
# `caption`, a line over the figure (default: none).

if (!exists("output")) { print "set output='FILE' by -e; see plots/README.md"; exit status 2 }
if (!exists("format")) format = 'svg'
if (!exists("caption")) caption = ''
if (!exists("width")) width = 800    # of the figure, in CSS pixels; the PNG has twice as many a side
if (!exists("height")) height = 450

# Palette: Okabe and Ito's, told apart with all common kinds of colour blindness; dash types tell lines apart in grey print.
blue = '#0072B2'
orange = '#E69F00'
green = '#009E73'
vermilion = '#D55E00'
black = '#000000'
grey = '#767676'
light_blue = '#8DC0E3'    # single trials behind a line of the same hue
light_orange = '#EFC766'
light_green = '#9ADBC5'
light_vermilion = '#F2BD94'
light_grey = '#DDDDDD'

dashed = 2
dotted = 3
dash_dotted = 4
set dashtype 2 (14, 11)
set dashtype 3 (1, 8)
set dashtype 4 (14, 8, 2, 8)

if (format eq 'png') {
    set terminal pngcairo enhanced size 2 * width, 2 * height font 'DejaVu Sans,10' rounded \
        fontscale 2 linewidth 2 pointscale 2 background '#FFFFFF'
} else {
    set terminal svg enhanced size width, height fixed font 'DejaVu Sans,12' rounded background '#FFFFFF'
}
set encoding utf8
set output output

set border 3 linecolor rgb grey linewidth 1
set xlabel offset 0, 0.3
set tics nomirror out scale 0.6 textcolor rgb black
set grid linetype 1 linecolor rgb light_grey linewidth 0.6 dashtype solid
set key at graph 1, 1.01 right bottom horizontal Left reverse samplen 3 noenhanced
set title offset 0, -0.3
thick = 2.2
thin = 1.3

# The run's files: comma-separated, `#` lines first, then one row of column names.
set datafile separator ','
set datafile columnheaders
set datafile commentschars '#'

# Mean of `value` over the last `window` rows, a display aid; nothing is drawn until so many rows have been read.
# Rows must come in order, `row` counted from 0; one buffer serves all, since gnuplot draws one curve after the other.
window = 100
array recent[window]
recent_sum = 0
slot(row) = int(row) % window + 1
running_mean(value, row) = \
    (row == 0 ? (recent_sum = 0) : 0, \
     recent_sum = recent_sum + value - (row < window ? 0 : recent[slot(row)]), \
     recent[slot(row)] = value, \
     row + 1 < window ? NaN : recent_sum / window)

# The step of round numbers that parts `span` into at most `parts`.
tic_step(span, parts) = (tic_raw = real(span) / parts, tic_power = 10 ** floor(log10(tic_raw)), \
    tic_power * (tic_raw <= tic_power ? 1 : tic_raw <= 2 * tic_power ? 2 : tic_raw <= 5 * tic_power ? 5 : 10))

degrees(angle_rad) = angle_rad * 180 / pi
millimetres(length_m) = length_m * 1000

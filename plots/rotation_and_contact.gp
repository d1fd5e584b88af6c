# rotation_and_contact.gp: how far the object has turned, and how hard each finger presses it, over one trial.
# Reads RUN/trajectory.csv. Use: gnuplot -e "run='RUN'; output='FILE'; format='svg'" plots/rotation_and_contact.gp
width = 800
height = 620
load ARG0[:strlen(ARG0) - strlen('rotation_and_contact.gp')] . 'style.gp'
trajectory = run . '/trajectory.csv'

set multiplot layout 2, 1 title caption noenhanced margins 0.095, 0.965, 0.1, 0.925 spacing 0.09
set xrange [0:3]
set xtics 0.5

set ylabel 'object rotation (rad)'
plot trajectory using "time_s":"object_rad" with lines linecolor rgb black linewidth thick notitle

set xlabel 'time (s)'
set ylabel 'contact force (N)'
set yrange [0:*]
plot trajectory using "time_s":"index_contact_n" with lines linecolor rgb blue linewidth thick title 'index', \
    '' using "time_s":"thumb_contact_n" with lines linecolor rgb vermilion linewidth thick dashtype dashed title 'thumb'
unset multiplot

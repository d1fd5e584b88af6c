# joint_angles.gp: desired and actual angles of the four driven joints over one trial (Fig. 6 of the paper).
# Reads RUN/trajectory.csv. Use: gnuplot -e "run='RUN'; output='FILE'; format='svg'" plots/joint_angles.gp
width = 800
height = 620
load ARG0[:strlen(ARG0) - strlen('joint_angles.gp')] . 'style.gp'
trajectory = run . '/trajectory.csv'

# Each panel spans its joint's whole range and a little more.
array joints[4] = ['fei', 'aai', 'fet', 'ot']
array names[4] = ['FEI: index flexion', 'AAI: index adduction', 'FET: thumb flexion', 'OT: thumb opposition']
array lower_deg[4] = [0, -15, 0, 0]
array upper_deg[4] = [90, 15, 90, 130]
array step_deg[4] = [15, 5, 15, 30]
margin_deg(joint) = 0.05 * (upper_deg[joint] - lower_deg[joint])

set multiplot layout 2, 2 columnsfirst title caption noenhanced margins 0.09, 0.965, 0.1, 0.86 spacing 0.09, 0.13
set xrange [0:3]
set xtics 0.5
do for [j = 1:4] {
    set title names[j]
    set yrange [lower_deg[j] - margin_deg(j):upper_deg[j] + margin_deg(j)]
    set ytics lower_deg[j], step_deg[j], upper_deg[j]
    set ylabel j <= 2 ? 'angle (deg; dotted: limits)' : ''
    set xlabel j % 2 == 0 ? 'time (s)' : ''
    if (j == 1) { set key at screen 0.53, 0.93 center center } else { unset key }
    plot trajectory using "time_s":(degrees(column('desired_' . joints[j] . '_rad'))) with lines \
            linecolor rgb black linewidth thin dashtype dashed title 'desired', \
        '' using "time_s":(degrees(column('actual_' . joints[j] . '_rad'))) with lines \
            linecolor rgb blue linewidth thick title 'actual', \
        lower_deg[j] with lines linecolor rgb grey linewidth thin dashtype dotted notitle, \
        upper_deg[j] with lines linecolor rgb grey linewidth thin dashtype dotted notitle
}
unset multiplot

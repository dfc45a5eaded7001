load "figures/style.gp"
set xlabel "Φ (degrees)"
set ylabel "dΦ/{/:Italic dt} (1/s)"
set xrange [-180:180]
set xtics 60
stats tsv("globe-25.portrait") using "Phi_deg":"smooth" nooutput
top = STATS_max_y
set yrange [-1.12 * top:1.12 * top]
set rmargin 5
set label "rolling" at 115, 0 center textcolor linetype 1  # between those that turn back at 90° and the middle one
file = tsv("globe-25.portrait")
plot for [i = 0:2] for [side = -1:1:2] file using "Phi_deg":(side * column("smooth")) index i with lines linetype 6 linewidth (i == 1 ? 2 : 0.8), \
     for [i = 0:2] for [side = -1:1:2] file using "Phi_deg":(side * column("rolling")) index i with lines linetype 1 linewidth (i == 1 ? 2 : 0.8), \
     file using "Phi_deg":"smooth":("smooth") index 1 every ::75::75 with labels left offset 1.6, 0.7 textcolor linetype 6

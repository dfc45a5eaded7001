short = 1
load "figures/style.gp"
set xlabel "way along the plane (feet)"
set ylabel "height (feet)"
set yrange [0.86:1.14]
set ytics 0.9, 0.1, 1.1
set label "{/:Italic C}" at graph 1.01, first 1 left textcolor linetype 7
set label "{/:Italic G}" at graph 1.01, first 0.9 left textcolor linetype 1
plot tsv("globe-10.path") using "s":(1):(column("x") - column("s")):(column("y") - 1) with vectors nohead linetype 6 linewidth 0.5, \
     "" using "x":"y" with linespoints linetype 1 linewidth 0.7, \
     "" using "s":(1) with points linetype 7

short = 1
load "figures/style.gp"
path = tsv("globe-10.path")
stats path using "C" name "C" nooutput
stats path using (abs(column("y") - column("C"))) name "G" nooutput
set xlabel "way along the plane (feet)"
set ylabel "height (feet)"
set yrange [C_max - 1.4 * G_max:C_max + 1.4 * G_max]
set label "{/:Italic C}" at graph 1.01, first C_max left textcolor linetype 7
set label "{/:Italic G}" at graph 1.01, first C_max - G_max left textcolor linetype 1
plot path using "s":"C":(column("x") - column("s")):(column("y") - column("C")) with vectors nohead linetype 6 linewidth 0.5, \
     "" using "x":"y" with linespoints linetype 1 linewidth 0.7, \
     "" using "s":"C" with points linetype 7

load "figures/style.gp"
set xlabel "energy {/:Italic h}"
set ylabel "friction over pressure"
set yrange [0:0.6]
set label "needed" at 33.6, 0.4 right textcolor linetype 1
set label "at 90°" at 33, 0.225 right textcolor linetype 6
set label "for small {/:Italic c}" at 33, 0.15 left textcolor linetype 2
plot tsv("globe-27.needs") using "h":"lambda" with lines linetype 1, \
     "" using "h":"right" with lines linetype 6 dashtype 2, \
     "" using "h":"small" with lines linetype 2

load "figures/style.gp"
set xrange [0:100]
set yrange [0:0.6]
set format y "%.1f"
set xlabel "terms"
set ylabel "sum"
set label "¾ {/:Italic l} 2" at 99, 0.55 right textcolor linetype 1
set label "terms alone" at 30, 0.38 left textcolor linetype 3
set label "with the bound" at 30, 0.55 left textcolor linetype 3
set label "¼ {/:Italic l} 2, in our copy" at 99, 0.145 right textcolor linetype 2
f = tsv("pendulum-27.sums")
plot 0.75 * log(2) with lines linetype 1, 0.25 * log(2) with lines linetype 2, \
     f using "terms":"sum" with points linetype 3 pointsize 0.25, \
     f every 4 using "terms":"with_bound" with points linetype 3 pointtype 4 pointsize 0.5

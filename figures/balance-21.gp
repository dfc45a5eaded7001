load "figures/style.gp"
set xrange [0:6]
set yrange [-10:120]
set ytics 30 format "%g°"
set xlabel "time (s)"
set ylabel "ω" offset 0, 0
set lmargin 10
set label "{/:Italic G} above" at 4.4, 50 right textcolor linetype 1
set label "formula" at 5.25, 95 right textcolor linetype 2
set label "in {/:Italic C}" at 5.95, 7 right textcolor linetype 4
set label "below" at 3.3, -6 center textcolor linetype 3
plot tsv("balance-21.beam") using "t":"formula" with lines linetype 2 dashtype (6, 5), \
     "" using "t":"above" with lines linetype 1, \
     "" using "t":"in" with lines linetype 4, \
     "" using "t":"below" with lines linetype 3

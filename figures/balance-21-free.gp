load "figures/style.gp"
set xrange [0:60]
set yrange [-1.4:1.4]
set ytics 0.5 format "%g°"
set xlabel "time (s)"
set ylabel "ω" offset 0, 0
set lmargin 10
set label "{/:Italic m} cos Λ{/:Italic t}" at 21, 1.2 left textcolor linetype 4
set label "full equations" at 35.5, 1.2 left textcolor linetype 1
plot 0 with lines linetype 6, \
     tsv("balance-21.free") using "t":"full" with lines linetype 1, \
     "" using "t":"slow" with lines linetype 4

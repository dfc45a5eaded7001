load "figures/style.gp"
set logscale y
set format y "10^{%T}"
set yrange [1e-5:3]
set xrange [0:900]
set xlabel "{/:Italic t} (seconds)"
set ylabel offset 0 "Q's swing, in parts of P's"
set label "heavy pans, ρ = 0.35" at 500, 0.004 left textcolor linetype 1
set label "light pans, ρ = 0.05" at 500, 4e-5 left textcolor linetype 3
file = tsv("balance-23.other_pan")
plot file using "t":"heavy" with lines linetype 1, file using "t":"light" with lines linetype 3, \
     file using "t":"theory" with lines linetype 6 dashtype (6, 4)

load "figures/style.gp"
set logscale xy
set xrange [1:300]
set yrange [0.04:1]
set ytics (0.05, 0.1, 0.2, 0.5, 1)
set xlabel "{/:Italic j}"
set ylabel "{/:Italic S_j}"
set label "½√(π/{/:Italic j})" at 6, 0.47 left textcolor linetype 6
set label "¾ {/:Italic l} 2" at 1.08, 0.47 left textcolor linetype 1
f = tsv("pendulum-28.law")
plot f using "j":"law" with lines linetype 6 dashtype (4, 4), f using "j":"S" with points linetype 1

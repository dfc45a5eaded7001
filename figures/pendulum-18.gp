load "figures/style.gp"
set logscale xy
set xrange [0.5:1000]
set yrange [3e-4:9]
set format y "10^{%T}"
set xlabel "{/:Italic m} + 1"
set ylabel "{/:Italic J_m}"
set label "α = 1°" at 1.15, 5.2 left textcolor linetype 1
set label "10°" at 0.95, 2.44 right textcolor linetype 1
set label "45°" at 0.95, 0.88 right textcolor linetype 1
set label "nearly 1/2{/:Italic m}" at 36, 0.0068 right textcolor linetype 6
f = tsv("pendulum-18.scaled")
plot f using (column("m") + 1):"J1" with lines linetype 1, "" using (column("m") + 1):"J10" with lines linetype 1, \
     "" using (column("m") + 1):"J45" with lines linetype 1

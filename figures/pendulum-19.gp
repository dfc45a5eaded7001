load "figures/style.gp"
set xrange [0.7:4]
set xtics 1, 0.5
set yrange [0:1]
set format y "%.1f"
set xlabel "ω / α"
set ylabel "part that is complete"
set label "1/sin^{11}ω" at 1.11, 0.82 right textcolor linetype 1
set label "1/sin^{5}ω" at 1.62, 0.78 left textcolor linetype 1
set label "1/sin^{3}ω" at 2.04, 0.69 left textcolor linetype 1
set label "1/sin ω" at 3.2, 0.24 left textcolor linetype 3
f = tsv("pendulum-19.complete")
plot for [i = 3:7] f using 1:i with lines linetype 1, f using "x":"p1" with lines linetype 3

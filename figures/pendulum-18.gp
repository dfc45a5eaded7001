load "figures/style.gp"
set logscale xy
set xrange [0.6:1000]
set yrange [6e-4:9]
set format y "10^{%T}"
set xlabel "power of sin ω, 2{/:Italic m} + 1"
set ylabel "{/:Italic J_m}"
set label "α = 1°" at 1.15, 5.5 left textcolor linetype 1
set label "10°" at 0.95, 2.44 right textcolor linetype 1
set label "45°" at 0.95, 0.88 right textcolor linetype 1
set label "1° and 10°" at 50, 0.0085 right textcolor linetype 1
set label "45°" at 115, 0.021 left textcolor linetype 1
f = tsv("pendulum-18.falling")
plot for [name in "J1 J10 J45"] f using "power":name with lines linetype 1

load "figures/style.gp"
set logscale xy
set xrange [1:2000]
set yrange [1e-16:3000]
set format x "%g"
set format y "10^{%T}"
set ytics 1e4
set xlabel "terms kept, {/:Italic N}"
set ylabel "part of Θ left out"
set label "ζ = 30°" at 6.2, 1e-10 right textcolor linetype 1
set label "90°" at 22, 1e-10 right textcolor linetype 1
set label "150°" at 230, 1e-10 right textcolor linetype 1
set label "175°" at 900, 3e-4 right textcolor linetype 1
set label "geometric bound" at 4, 400 left textcolor linetype 6
left_out = tsv("pendulum-08.lacking")
plot left_out using "terms":"geometric" with lines linetype 6, \
     left_out using "terms":"R" with lines linetype 1 linewidth 1.2, \
     left_out using "terms":"lower" with points linetype 3 pointtype 7 pointsize 0.25, \
     left_out using "terms":"upper" with points linetype 3 pointtype 7 pointsize 0.25

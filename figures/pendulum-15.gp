load "figures/style.gp"
set logscale xy
set xrange [1e-4:2e4]
set yrange [1e-18:10]
set xtics 100 format "10^{%T}"
set ytics 1e3 format "10^{%T}"
set xlabel "way gone, (ψ − η)/η"
set ylabel "left out of {/:Italic t}√(2{/:Italic g}/{/:Italic b})"
set arrow from 1e-4, log(2) to 2e4, log(2) nohead linetype 6 dashtype (6, 4)
set label "the first term" at 3, 0.02 textcolor linetype 2
set label "formula (B), η = 5°" at 45, 4e-6 left textcolor linetype 1
set label "1°" at 240, 7e-9 left textcolor linetype 1
set label "0.01°" at 1.5e4, 3e-15 right textcolor linetype 1
set label "{/:Italic l} 2" at 3e-4, 4 left textcolor linetype 6
short = tsv("pendulum-15.short")
plot short using "x":"first" with lines linetype 2, \
     short using "x":"uniform" with lines linetype 1

load "figures/style.gp"
set logscale xy
set xrange [1e-8:1]
set yrange [1e-17:1e17]
set format xy "10^{%T}"
set ytics 1e-16, 1e8
set xlabel "v"
set ylabel "size"
set label "the greatest part" at 2e-5, 1e11 left textcolor linetype 6
set label "the whole, {/:Italic W}" at 2e-6, 1e-14 left textcolor linetype 1
set label "the whole by (1), in sixteen digits" at 1.5e-6, 3e-2 left textcolor linetype 3
f = tsv("pendulum-25.parts")
plot f using "v":"part" with lines linetype 6, "" using "v":"W" with lines linetype 1, \
     "" using "v":"stands" with points linetype 3 pointsize 0.2

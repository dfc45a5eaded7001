load "figures/style.gp"
set logscale xy
set xrange [0.25:16]
set yrange [0.25:8]
set xtics (0.25, 0.5, 1, 2, 4, 8, 16)
set ytics (0.25, 0.5, 1, 2, 4, 8)
set rmargin 9
set xlabel "length {/:Italic b} (feet)"
set ylabel "time of one swing {/:Italic T} (seconds)"
set label "ζ = 0°" at 17, 2.05 textcolor linetype 1
set label "90°" at 17, 2.72 textcolor linetype 1
set label "150°" at 17, 3.95 textcolor linetype 1
set label "175°" at 17, 6.5 textcolor linetype 1
set arrow from 0.25, 1 to 16, 1 nohead linetype 6
set label "one second" at 5, 0.9 textcolor linetype 6
plot for [i = 2:5] tsv("pendulum-09.lengths") using 1:i with lines linetype 1, \
     tsv("pendulum-09.beat") using "b":(1) with points linetype 2 pointtype 7 pointsize 0.7

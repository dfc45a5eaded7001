load "figures/style.gp"
set xlabel "time (seconds)"
set ylabel "amplitude, in parts of {/:Italic n}"
file = tsv("balance-31.envelopes")
stats file using "t" name "T" nooutput
set xrange [0:T_max]
set yrange [0:1.2]
set label "P" at 0.16 * T_max, 1.05 center textcolor linetype 1
set label "Q" at 0.47 * T_max, 1.08 center textcolor linetype 3
plot file using "t":"P" with lines linetype 1, file using "t":"Q" with lines linetype 3

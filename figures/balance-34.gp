load "figures/style.gp"
file = tsv("balance-34.by_arm")
stats file using "i" name "I" nooutput
set xrange [0:8]
set yrange [0:1.1 * I_max]
set xlabel "half the beam, feet"
set ylabel "{/:Italic i}, 1/s"
plot file using "a":"i" with lines linetype 1

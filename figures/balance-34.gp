load "figures/style.gp"
file = tsv("balance-34.by_arm")
stats file using "i" name "I" nooutput
set logscale x
set xrange [0.01:10]
set yrange [0:1.1 * I_max]
set xlabel "half the beam (feet)"
set ylabel "{/:Italic i} (1/s)"
set arrow from 0.01, I_max to 10, I_max nohead linetype 6 back
plot file using "a":"i" with lines linetype 1

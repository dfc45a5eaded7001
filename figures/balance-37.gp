load "figures/style.gp"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "offset {/:Italic e} (feet)"
set ylabel "time of the exchange (seconds)"
plot tsv("balance-37.times") using "e":"time" with lines linetype 1

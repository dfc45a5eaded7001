load "figures/style.gp"
file = tsv("balance-04.parts")
set logscale x
set format x "10^{%L} %%"
set yrange [0:1.08]
set lmargin 9
stats file using "longer":"once" nooutput
set xrange [STATS_min_x:STATS_max_x]
set xlabel "difference of the strings"
set ylabel "part of the swing that Q gets"
# where a curve has come down to one half
half(c) = system(sprintf("awk -F'\\t' 'NR>1 && $%d<0.5 {print $1; exit}' '%s'", c, file)) + 0
h1 = half(2); h2 = half(3); h3 = half(4)
if (h1 > 0) set label "{/:Italic T}" at h1 * 1.25, 0.53 left textcolor linetype 1
if (h2 > 0) set label "4{/:Italic T}" at h2 * 1.25, 0.53 left textcolor linetype 3
if (h3 > 0) set label "exchange in 16{/:Italic T}" at h3 / 1.3, 0.45 right textcolor linetype 4
plot file using "longer":"once" with lines linetype 1, "" using "longer":"four" with lines linetype 3, \
     "" using "longer":"sixteen" with lines linetype 4

load "figures/style.gp"
file = tsv("balance-04.parts")
set logscale x
set format x "10^{%L} %%"
set lmargin 9
# where a curve has come down to one half
h1 = h2 = h3 = 0
first(c, h) = h == 0 && column(c) < 0.5 ? column("longer") : h
stats file using (h1 = first("once", h1), h2 = first("four", h2), h3 = first("sixteen", h3)) nooutput
stats file using "longer":"once" nooutput
set yrange [0:1.08]
set xrange [STATS_min_x:STATS_max_x]
set xlabel "difference of the strings"
set ylabel "part of the swing that Q gets"
if (h1 > 0) set label "{/:Italic T}" at h1 * 1.25, 0.53 left textcolor linetype 1
if (h2 > 0) set label "4{/:Italic T}" at h2 * 1.25, 0.53 left textcolor linetype 3
if (h3 > 0) set label "exchange in 16{/:Italic T}" at h3 / 1.3, 0.45 right textcolor linetype 4
plot file using "longer":"once" with lines linetype 1, "" using "longer":"four" with lines linetype 3, \
     "" using "longer":"sixteen" with lines linetype 4

# Error against time for one evaluation, for any race. Besides `data` and `out`: `race`, the data's name, and `families`,
# how many lines of methods it has. Blocks: all methods, the front, the names, then one block a family.
load "figures/style.gp"
set logscale xy
set format x "10^{%T} s"
set format y "10^{%T}"
set xlabel "time of one evaluation"
set ylabel "relative error"
set offsets graph 0.03, graph 0.34, graph 0.06, graph 0.05
set autoscale
plot tsv(race) index 1 using "seconds":"error" with steps lt 6 dt (6, 3), \
     for [i = 1 : families] tsv(race) index 2 + i using "seconds":"error" with lines lt 2, \
     tsv(race) index 0 using "seconds":"error" with points lt 1 ps 0.7, \
     tsv(race) index 2 using "seconds":"height":"name" with labels left offset 0.9, 0 textcolor lt 7

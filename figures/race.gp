# Error against time for one evaluation, for any race. Besides `data` and `out`: `race`, the data's name;
# `families`, how many lines of methods it has; `left`, `right`, `low`, `high`, the frame. Blocks of the data:
# all methods, the front, the names, and the families, parted by empty lines. The names stand at the right
# edge, each tied to its point.
load "figures/style.gp"
set logscale xy
set format x "10^{%T} s"
set format y "10^{%T}"
set xlabel "time of one evaluation"
set ylabel "relative error"
set xrange [left:right]
set yrange [low:high]
set rmargin at screen 0.69
lines_of_families = families ? "tsv(race) index 3 using 'seconds':'error' with lines lt 2," : ""
plot @lines_of_families \
     tsv(race) index 1 using "seconds":"error" with steps lt 6 dt (6, 3), \
     tsv(race) index 2 using 2:3:(right - $2):($4 - $3) with vectors nohead lc rgb faint lw 1, \
     tsv(race) index 0 using "seconds":"error" with points lt 1 ps 0.7, \
     tsv(race) index 2 using (0.999 * right):"height":"name" with labels left offset 0.5, 0 textcolor lt 7

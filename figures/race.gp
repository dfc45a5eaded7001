# Error against time for one evaluation, for any race. Besides `data` and `out`: `source`, the data's name;
# `quantity`, what the error is; `families`, how many lines of methods it has; `clipped`, the error at which smaller
# ones are drawn, or 0 where there are none; `left`, `right`, `low`, `high`, the frame, `edge`, where it ends,
# as a part of the drawing's width, and `every`, the step of its lower scale. Blocks of the data: all methods, the
# front, the names, and the families, parted by empty lines. The names stand at the right edge, each tied to its
# point.
load "figures/style.gp"
set logscale xy
set format x "10^{%T} s"
set xtics every
set format y "10^{%T}"
set xlabel "time of one evaluation"
set ylabel quantity
set xrange [left:right]
set yrange [low:high]
set rmargin at screen edge
if (clipped > 0) \
  set arrow from left, clipped to right, clipped nohead lt 6 dt (2, 4); \
  set label "what is nearer is drawn here" at right, clipped right offset -0.6, -0.7 font ",14" textcolor lt 6
lines_of_families = families ? \
  "tsv(source) index 3 using 'seconds':'drawn':'colour' with lines linecolor variable lw 1.2," : ""
plot @lines_of_families \
     tsv(source) index 1 using "seconds":"drawn" with steps lt 6 dt (6, 3), \
     tsv(source) index 2 using 2:4:(right - $2):($5 - $4) with vectors nohead lc rgb faint lw 1, \
     tsv(source) index 0 using "seconds":"drawn":"colour" with points pt 7 ps 0.7 linecolor variable, \
     for [colour in "1 2 3 7"] tsv(source) index 2 \
       using (0.999 * right):"height":(column("colour") == colour + 0 ? stringcolumn("name") : "") \
       with labels left offset 0.5, 0 noenhanced textcolor lt colour

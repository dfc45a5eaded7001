# The worst errors of several methods, scene by scene from the top down. Besides `data` and `out`: `source`, the
# data's name; `ways`, how many methods; `rows`, the last scene's number; `unit`, that of the errors. Blocks of the
# data: one for each method, and the names, each where its method stands apart from the others.
tall = 1
load "figures/style.gp"
set lmargin at screen 0.32
set logscale x
set format x "10^{%T}"
set xlabel sprintf("worst error (%s)", unit)
set xrange [1e-3:1e17]
set yrange [rows + 0.5:-0.9]
set border 1
set tics nomirror
unset grid
set grid xtics linetype 1 linecolor rgb faint linewidth 0.7
set ytics scale 0
plot for [way = 0 : ways - 1] tsv(source) index way using "error":"row":"colour" \
       with lines linecolor variable lw 1.2, \
     for [way = 0 : ways - 1] tsv(source) index way using "error":"row":"colour":yticlabels(1) \
       with points pt 7 ps 0.7 linecolor variable, \
     for [colour = 1 : 7] tsv(source) index ways \
       using "error":"row":(column("colour") == colour ? stringcolumn("name") : "") \
       with labels boxed offset 0, 0.95 noenhanced textcolor lt colour

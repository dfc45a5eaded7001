load "figures/style.gp"
set logscale y
set xrange [1:17.5]
set yrange [1e-23:1e10]
set format y "10^{%T}"
set xtics 1, 3
set xlabel "power of {/:Italic kk}"
set ylabel "size of the correction, over {/:Italic a}"
set rmargin 5
plot tsv("tautochrone-27.fall_and_rise") using "n":"size" with linespoints linetype 1, \
     "" using (column("n") + 0.25):"size":(column("n") == 16 ? sprintf("%d°", column("phi")) : "") with labels left textcolor linetype 1

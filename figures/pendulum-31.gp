short = 1
load "figures/style.gp"
lo = 3.826745; hi = 3.826755
set xrange [1.000472:1.000483]
set yrange [3.826725:3.826775]
set xtics 0.000004 format "%.6f"
set ytics 0.00001 format "%.5f"
set xlabel "factor"
set ylabel "product" offset 2, 0
set object 1 rectangle from 1.000472, lo to 1.000483, hi fillcolor rgb blue fillstyle solid 0.12 noborder behind
set label "rounds to 3,82675" at 1.0004722, 3.8267485 left textcolor linetype 1
set label "true" at 1.00047617, 3.8267405 center textcolor linetype 1
set label "printed" at 1.0004801, 3.8267665 center textcolor linetype 2
plot tsv("pendulum-31.factors") using "factor":"product" with lines linetype 7, \
     "+" using (1.00047617249):(1.00047617249 * 2.3025851 * 1.6611437) every ::0::0 with points linetype 1 pointsize 1, \
     "+" using (1.0004801):(1.0004801 * 2.3025851 * 1.6611437) every ::0::0 with points linetype 2 pointsize 1.1

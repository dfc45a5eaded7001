load "figures/style.gp"
set logscale x
set xrange [1:1e-32]
set yrange [0:40]
set xtics ("1" 1, "10^{−5}" 1e-5, "10^{−10}" 1e-10, "10^{−15}" 1e-15, "10^{−20}" 1e-20, "10^{−25}" 1e-25, "10^{−30}" 1e-30)
set ytics 10 format "%g %%"
set xlabel "η (radians)"
set ylabel "part missing"
set label "5°" at 5e-3, 16.4 left textcolor linetype 2
set label "1°" at 1.4e-3, 12.2 left textcolor linetype 2
set label "1 %" at 6e-30, 3.2 center textcolor linetype 2
plot tsv("pendulum-16.parts") using "eta":(100 * column("part")) with lines linetype 2, \
     tsv("pendulum-16.examples") using "eta":(100 * column("part")) with points linetype 2 pointtype 7 pointsize 0.8

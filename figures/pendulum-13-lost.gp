load "figures/style.gp"
set logscale xy
set xrange [1:1e-12]
set yrange [1e-18:1]
set xtics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8, "10^{−10}" 1e-10, "10^{−12}" 1e-12)
set ytics 1e3 format "10^{%T}"
set xlabel "η (radians)"
set ylabel "relative error of {/:Italic T}"
set label "from {/:Italic c} = cos ½η" at 3e-4, 1e-8 right textcolor linetype 2
set label "no number" at 1e-10, 1e-2 center textcolor linetype 2
set label "from η" at 1e-9, 3e-15 center textcolor linetype 1
plot tsv("pendulum-13.lost") using "eta":"rounding" with lines linetype 6, \
     "" using "eta":"from_c" with points linetype 2 pointtype 7 pointsize 0.3, \
     "" using "eta":"from_eta" with points linetype 1 pointtype 7 pointsize 0.3

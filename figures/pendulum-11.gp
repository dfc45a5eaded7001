load "figures/style.gp"
set xrange [0:180]
set xtics 30 format "%g°"
set yrange [0.8:4.2]
set rmargin 4
set xlabel "amplitude ζ"
set ylabel "{/:Italic T} / Θ"
set arrow from 90, 0.8 to 90, 1.18034 nohead linetype 6
set label "semicircle" at 88, 1.36 right textcolor linetype 1
set label "exact" at 157, 2.45 right textcolor linetype 1
set label "Euler's five terms" at 178, 1.26 right textcolor linetype 2
set label "(2/π) ln(8/η)" at 114, 1.0 left textcolor linetype 6
plot tsv("pendulum-11.ratio_curve") using "zeta":(column("near_the_top") > 0.9 ? column("near_the_top") : NaN) with lines linetype 6 dashtype (4, 4), \
     "" using "zeta":"five_terms" with lines linetype 2, \
     "" using "zeta":"exact" with lines linetype 1

load "figures/style.gp"
set logscale xy
set xrange [0.01:2]
set yrange [1e-14:1]
set xtics ("0.01" 0.01, "0.03" 0.03, "0.1" 0.1, "0.3" 0.3, "1" 1)
set ytics ("1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12)
set xlabel "eccentricity {/:Italic c}/{/:Italic k}"
set ylabel "error at 90°, over {/:Italic k}"
set label "with {/:Italic cc}/3{/:Italic k}" at 0.03, 5e-4 right textcolor linetype 2
set label "with 2{/:Italic cc}/3{/:Italic k}" at 0.04, 8e-7 right textcolor linetype 1
set label "and the next term" at 0.2, 3e-8 left textcolor linetype 3
set arrow from 1. / 6, 1e-14 to 1. / 6, 1 nohead linetype 6
set label "our ball" at 0.175, 4e-14 left textcolor linetype 6
plot tsv("globe-18.readings") using "c":"one" with lines linetype 2, \
     "" using "c":"two" with lines linetype 1, \
     "" using "c":"next" with lines linetype 3

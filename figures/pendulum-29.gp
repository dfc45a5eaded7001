load "figures/style.gp"
set logscale x
set xrange [0.2:90]
set xtics ("0.2°" 0.2, "0.5°" 0.5, "1°" 1, "2°" 2, "5°" 5, "10°" 10, "20°" 20, "50°" 50)
set yrange [0:8]
set xlabel "η, from the top to where the descent begins"
set ylabel "T / Θ"
set label "(2), as it stands" at 5.5, 4.75 left textcolor linetype 2
set label "(A), with 2/π" at 9, 1.75 right textcolor linetype 1
set label "his definitions" at 0.64, 3.66 right textcolor linetype 7
set label "his series" at 1.27, 3.14 right textcolor linetype 7
set label "the motion" at 2.5, 2.62 right textcolor linetype 7
f = tsv("pendulum-29.laws")
p = tsv("pendulum-29.found")
plot f using "eta":"printed" with lines linetype 2, \
     f using "eta":"mended" with lines linetype 1, \
     p every 3::0 using "eta":"definitions" with points linetype 7 pointtype 5 pointsize 0.45, \
     p every 3::1 using "eta":"series" with points linetype 7 pointtype 7 pointsize 0.45, \
     p every 3::2 using "eta":"motion" with points linetype 7 pointtype 9 pointsize 0.6

load "figures/style.gp"
set xrange [140:186]
set xtics 10 format "%g°"
set yrange [0:7]
set xlabel "amplitude ζ"
set ylabel "T / Θ"
set arrow 1 from 175, 2.96 to 175, 4.42 nohead linetype 6 dashtype (3, 3)
set arrow 2 from 179, 3.98 to 179, 6.03 nohead linetype 6 dashtype (3, 3)
set label "4,52023, printed" at 174, 4.55 right textcolor linetype 2
set label "6,12777, restored" at 178, 6.15 right textcolor linetype 2
set label "2.87766" at 174, 3.05 right textcolor linetype 1
set label "3.90107" at 179.9, 3.85 left textcolor linetype 1
plot tsv("pendulum-36.swings") using "zeta":"ratio" with lines linetype 1, \
     "+" using (175):(2.87766) every ::0::0 with points linetype 1 pointsize 0.8, \
     "+" using (179):(3.90107) every ::0::0 with points linetype 1 pointsize 0.8, \
     "+" using (175):(4.52023) every ::0::0 with points linetype 2 pointsize 1, \
     "+" using (179):(6.12777) every ::0::0 with points linetype 2 pointtype 8 pointsize 1

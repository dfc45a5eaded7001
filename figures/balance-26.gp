load "figures/style.gp"
set xrange [0:4]
set yrange [-6:6]
set xlabel "λ/μ"
set ylabel "{/:Italic K} : ({/:Italic am/b})"
set arrow from 2, graph 0 to 2, graph 1 nohead linetype 6 dashtype (4, 4)
set arrow from 0, 0 to 4, 0 nohead linetype 6
set arrow from 0, -1 to 4, -1 nohead linetype 6 dashtype (2, 4)
set label "λ = 2μ" at 2.06, 5.4 left textcolor linetype 6
set label "Euler’s example" at 0.36, 0.8 left textcolor linetype 2
set label "−1" at 3.9, -0.6 right textcolor linetype 6
plot tsv("balance-26.slower") using "r":"K" with lines linetype 1, \
     tsv("balance-26.faster") using "r":"K" with lines linetype 1, \
     "+" using (1./3):(1./35) every ::0::0 with points linetype 2 pointsize 0.9

load "figures/style.gp"
set logscale xy
set xrange [0.01:100]
set yrange [1e-9:3]
set xtics ("0.01°" 0.01, "0.1°" 0.1, "1°" 1, "10°" 10, "90°" 90)
set format y "10^{%T}"
set xlabel "angle"
set ylabel "left out : kept" offset 0, 0
set lmargin 10
set label "{/:Italic A} sideways : upward" at 0.13, 4e-3 right textcolor linetype 2
set label "1 − cos ω : 1" at 0.28, 3e-5 right textcolor linetype 1
set label "(ω − sin ω) : ω" at 0.3, 1.5e-6 left textcolor linetype 3
plot tsv("balance-11.small") using "degrees":"sideways" with lines linetype 2, \
     "" using "degrees":"cosine" with lines linetype 1, \
     "" using "degrees":"sine" with lines linetype 3

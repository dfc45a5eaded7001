load "figures/style.gp"
set xrange [0:360]
set xtics 60 format "%g°"
set yrange [-12:14]
set format y "%g %%"
set xlabel "phase γ of the beam when the pan is let go"
set ylabel "𝔄 over the release, less 1" offset 0, 0
set lmargin 10
set label "λ = 1.5 μ" at 275, 13 right textcolor linetype 2
set label "λ = μ" at 312, 3.6 left textcolor linetype 3
set label "λ = μ/3" at 92, 1.1 center textcolor linetype 1
plot 0 with lines linetype 6, \
     tsv("balance-19.moments") using "gamma":"faster" with lines linetype 2, \
     "" using "gamma":"equal" with lines linetype 3, \
     "" using "gamma":"third" with lines linetype 1

load "figures/style.gp"
file = tsv("balance-30.spectrum")
stats file using "frequency":"amplitude" name "S" nooutput
stats tsv("balance-30.euler") using "frequency":"amplitude" name "E" nooutput
set xrange [0:S_max_x]
set logscale y
set format y "10^{%T}"
set yrange [3e-5:3]
set xlabel "frequency (1/s)"
set ylabel "amplitude, in parts of {/:Italic n}"
step = (E_max_x - E_min_x) / 2
mu = E_min_x + step
set label "μ" at mu + 0.25 * step, 1 left textcolor linetype 2
set label "μ − λ" at mu - 1.25 * step, 0.012 right textcolor linetype 2
set label "μ + λ" at mu + 1.25 * step, 0.012 left textcolor linetype 2
set label "2λ" at 1.75 * step, 0.012 right textcolor linetype 1
plot file using "frequency":"amplitude" with lines linetype 1, \
     tsv("balance-30.euler") using "frequency":"amplitude" with points linetype 2

load "figures/style.gp"
set logscale xy
set xrange [1e-15:1]
set yrange [1e-17:10]
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "step {/:Italic h}, in 1/μ"
set ylabel "error, in parts of μ𝔄" offset 0, 0
set lmargin 10
set label "one-sided" at 3e-4, 2e-3 right textcolor linetype 2
set label "central" at 1e-11, 2e-7 right textcolor linetype 3
set label "complex step" at 1e-11, 2e-15 center textcolor linetype 1
plot tsv("balance-20.steps") using "h":"one_sided" with lines linetype 2, \
     "" using "h":"central" with lines linetype 3, \
     "" using "h":"complex" with lines linetype 1

load "figures/style.gp"
curves = "globe-17.readings"
do for [name in "two one next"] {
  stats tsv(curves) using (column(name) > 0 ? column(name) : NaN) every ::34::34 nooutput
  eval name . "_at = STATS_max"
}
set logscale xy
set xrange [0.01:2]
set xtics ("0.01" 0.01, "0.03" 0.03, "0.1" 0.1, "0.3" 0.3, "1" 1)
set format y "10^{%L}"
set lmargin 9
set xlabel "eccentricity {/:Italic c} : {/:Italic k}"
set ylabel "error over {/:Italic k}"
set label "with {/:Italic cc} : 3{/:Italic k}" at 0.0525, one_at right offset -0.5, 0.7 textcolor linetype 2
set label "with 2{/:Italic cc} : 3{/:Italic k}" at 0.0525, two_at right offset -0.5, 0.7 textcolor linetype 1
set label "and the next term" at 0.0525, next_at left offset 1.5, -0.3 textcolor linetype 3
plot tsv(curves) using "c":"one" with lines linetype 2, \
     "" using "c":"two" with lines linetype 1, \
     "" using "c":"next" with lines linetype 3

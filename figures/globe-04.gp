load "figures/style.gp"
file = tsv("globe-04.limits")
array K[3]; array M[3]; array C[3]
do for [i = 1:3] {
  stats file index i - 1 using (K[i] = column("k"), M[i] = column("limit"), C[i] = column("c"), 0) nooutput
}
set logscale xy
set xrange [0.01:1]
set yrange [0.01:10]
set xtics ("0.01" 0.01, "0.03" 0.03, "0.1" 0.1, "0.3" 0.3, "1" 1)
set ytics ("0.01" 0.01, "0.1" 0.1, "1/3" 1. / 3, "1" 1, "10" 10)
set rmargin 10
set xlabel "radius of gyration {/:Italic k}/{/:Italic a}"
set ylabel "greatest μ"
set arrow from 0.01, 1. / 3 to 1, 1. / 3 nohead linetype 2
do for [i = 1:3] {
  set label sprintf("{/:Italic c} = %.1f {/:Italic a}", C[i]) at K[i], M[i] left offset 1.2, (i == 2 ? 0.8 : 0.2) textcolor linetype 1
}
plot for [i = 0:2] file index i using "k":"enough" with lines linetype 6, \
     for [i = 0:2] file index i using "k":"limit" with lines linetype 1

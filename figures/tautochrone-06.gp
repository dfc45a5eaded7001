load "figures/style.gp"
file = tsv("tautochrone-06.lengths")
set xrange [0:5]
set yrange [0:5.4]
set xtics 1 format "%g {/:Italic k}"
set ytics 1 format "%g {/:Italic k}"
set xlabel "distance {/:Italic d} of the axis from the centre of gravity"
set ylabel "{/:Italic AD}"
set arrow from 0, 2.5 to 5, 2.5 nohead linetype 3 dashtype 3
set arrow from 0.5, 0 to 0.5, 2.5 nohead linetype 3 dashtype 3
set arrow from 2, 0 to 2, 2.5 nohead linetype 3 dashtype 3
set label "" at 0.5, 2.5 point linetype 3 pointtype 7
set label "" at 2, 2.5 point linetype 3 pointtype 7
set label "" at 1, 2 point linetype 1 pointtype 7
set label "least, 2{/:Italic k}" at 1, 1.78 center textcolor linetype 1
set label "{/:Italic d} + {/:Italic kk}/{/:Italic d}" at 4.3, 4.85 right textcolor linetype 1
set label "{/:Italic d}" at 4.4, 4.1 left textcolor linetype 6
set label "{/:Italic kk}/{/:Italic d}" at 4.2, 0.45 left textcolor linetype 6
plot file using "d":"d" with lines linetype 6, "" using "d":"other" with lines linetype 6, \
     "" using "d":"AD" with lines linetype 1

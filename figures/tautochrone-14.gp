tall = 1
load "figures/style.gp"
unset border; unset tics; unset grid
set xrange [-3.6:5.4]
set yrange [-2.6:2.3]
file = tsv("tautochrone-14.lines")
set arrow from 0, -2.25 to 0, 2.1 nohead linetype 6
set label "{/:Italic G}" at 1.2, 0.1 left textcolor linetype 7
set label "2{/:Italic k}" at -0.2, 2 right textcolor linetype 3
set label "{/:Italic k}" at -0.2, 1 right textcolor linetype 1
set label "½{/:Italic k}" at -0.2, 0.38 right textcolor linetype 2
set label "{/:Italic P} at {/:Italic G}" at -1.7, 0 right textcolor linetype 6
set label "{/:Italic P} at ½{/:Italic k}" at -1.7, -0.5 right textcolor linetype 3
set label "{/:Italic P} at {/:Italic k}" at -1.7, -1 right textcolor linetype 1
set label "{/:Italic P} at 2{/:Italic k}" at -1.7, -2 right textcolor linetype 2
set arrow from -1.6, 0 to -0.05, 0 linetype 6
set arrow from -1.6, -0.5 to -0.05, -0.5 linetype 3
set arrow from -1.6, -1 to -0.05, -1 linetype 1
set arrow from -1.6, -2 to -0.05, -2 linetype 2
plot file using "b0":"place" with lines linetype 6 dashtype (6, 4), \
     file using "b_half":"place" with lines linetype 3, \
     file using "b_one":"place" with lines linetype 1, \
     file using "b_two":"place" with lines linetype 2, \
     file every 10::40::40 using (0 * column("place")):"place" with points linetype 3 pointsize 1, \
     file every ::30::30 using (0 * column("place")):"place" with points linetype 1 pointsize 1, \
     file every ::25::25 using (0 * column("place")):"place" with points linetype 2 pointsize 1, \
     file every ::20::20 using "b0":"place" with points linetype 7 pointsize 1

tall = 1
load "figures/style.gp"
set size ratio -1
unset border; unset tics; unset grid
set xrange [-0.85:0.85]
set yrange [-1.08:0.1]
cheek(phi) = 0.5 * (phi - sin(phi) * cos(phi))
do for [i = -2:2] {
  phi = i * 0.5
  set arrow from cheek(phi), -0.5 * sin(phi)**2 to cheek(phi) + cos(phi) * sin(phi), -0.5 * sin(phi)**2 - cos(phi)**2 \
    nohead linetype 7
}
set label "{/:Italic A}" at 0, 0.06 center textcolor linetype 7
set label "{/:Italic C}" at 0, -1.05 center textcolor linetype 7
set label "cheek" at 0.5, -0.36 left textcolor linetype 2
set label "the bob’s cycloid" at 0.3, -1.02 left textcolor linetype 1
file = tsv("tautochrone-02.cheek")
bob(i) = cheek(i * 0.5) + cos(i * 0.5) * sin(i * 0.5)
low(i) = -0.5 * sin(i * 0.5)**2 - cos(i * 0.5)**2
do for [i = -2:2] { set object i + 3 circle at bob(i), low(i) size 0.018 fillstyle solid 1 border linetype 7 fillcolor linetype 7 front }
plot file using "q":(-column("p")) with lines linetype 2, \
     file using "y":(column("x") - 1) with lines linetype 1

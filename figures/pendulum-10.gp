tall = 1
load "figures/style.gp"
unset border
unset tics
unset grid
set size ratio -1
set offsets graph 0.15, graph 0.15, graph 0.06, graph 0.08
points = tsv("pendulum-10.points")
arc = tsv("pendulum-10.arc")
name(i) = word("B A O D G", int(i) + 1)
plot arc using "x":"y" with lines linetype 6 dashtype (4, 4), \
     arc using (0.2 * column("x")):(0.2 * column("y")) with lines linetype 6, \
     points using 1:2 every ::0::3 with lines linetype 7, \
     points using 1:2 every 3::0::3 with lines linetype 2 linewidth 2.4, \
     points using 1:2 every ::0::4 with points linetype 7, \
     points using 1:2:(name($0)) every ::0::1 with labels font ",18" offset -1.4, 0, \
     points using 1:2:("D") every ::3::3 with labels font ",18" offset -1.4, 0, \
     points using 1:2:(name(2 * $0 + 2)) every 2::2::4 with labels font ",18" offset 1.5, 0.2, \
     points using 1:2:("d") every ::5::5 with labels offset -1.4, 0 textcolor linetype 2, \
     points using ($1 / 2):($2 / 2):("b") every ::2::2 with labels offset 2.2, 0.5, \
     arc using (0.26 * $1):(0.26 * $2):("ζ") every ::30::30 with labels

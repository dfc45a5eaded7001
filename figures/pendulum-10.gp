tall = 1
load "figures/style.gp"
unset border
unset tics
unset grid
set size ratio -1
set offsets graph 0.15, graph 0.15, graph 0.06, graph 0.08
points = tsv("pendulum-10.points")
name(i) = word("A B D d O G b ζ", int(i) + 1)
plot tsv("pendulum-10.arc") using "x":"y" with lines linetype 6 dashtype (4, 4), \
     "" using "mark_x":"mark_y" with lines linetype 6, \
     tsv("pendulum-10.lines") using 1:2 with lines linetype 7, \
     points using 1:2 every ::1::2 with lines linetype 2 linewidth 2.4, \
     points using 1:2 every ::0::2 with points linetype 7, \
     points using 1:2 every ::4::5 with points linetype 7, \
     points using 1:2:(name($0)) every ::0::2 with labels font ",18" offset -1.4, 0, \
     points using 1:2:("d") every ::3::3 with labels offset -1.4, 0 textcolor linetype 2, \
     points using 1:2:(name($0 + 4)) every ::4::6 with labels offset 1.4, 0.1, \
     points using 1:2:("ζ") every ::7::7 with labels offset 0, -0.8

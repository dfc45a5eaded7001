load "figures/style.gp"
curves = "globe-12.parts"
stats tsv(curves) using "Phi" nooutput; end = STATS_max
stats tsv(curves) using (column("turning") + column("upright")) nooutput; high = STATS_max
set xlabel "angle Φ (degrees)"
set ylabel "living force over {/:Italic P}, without {/:Italic ff} (ft²/s²)"
set xrange [-end:end]
set yrange [0:1.1 * high]
if (end > 60) set xtics 60
set label "turning" at 0, 0.2 * high center textcolor linetype 1
set label "rise and fall of {/:Italic G}" at 0, 1.06 * high center textcolor linetype 3
array E[181]
stats tsv(curves) using (E[int($0) + 1] = column("alike")) nooutput
set label "of a ball with {/:Italic k} = {/:Italic c}" at -0.5 * end, E[46] left offset 1.5, -0.6 textcolor linetype 3
plot tsv(curves) using "Phi":(0):"turning" with filledcurves linecolor rgb blue, \
     "" using "Phi":"turning":(column("turning") + column("upright")) with filledcurves linecolor rgb green \
        fillstyle transparent solid 0.6 noborder, \
     "" using "Phi":"alike" with lines linetype 3 dashtype 2, \
     "" using "Phi":(column("turning") + column("upright")) with lines linetype 7

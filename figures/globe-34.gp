load "figures/style.gp"
file = tsv("globe-34.ratios")
stats file using "Phi_deg":"rough" nooutput
top = STATS_max_y
set xlabel "amplitude (degrees)"
set ylabel "swing over a very small one"
set xrange [0:180]
set yrange [1:1 + 1.05 * (top - 1)]
plot file using "Phi_deg":"hung" with lines linetype 6 linewidth 1.6, \
     file using "Phi_deg":"smooth" with lines linetype 3, \
     file using "Phi_deg":"rough" with lines linetype 1, \
     "" using "Phi_deg":"hung":("hung up") every ::159::159 with labels left offset 1, -0.6 textcolor linetype 6, \
     "" using "Phi_deg":"rough":("rolling") every ::139::139 with labels right offset -1, 0.6 textcolor linetype 1, \
     "" using "Phi_deg":"smooth":("smooth plane") every ::119::119 with labels left offset 1.2, -0.8 textcolor linetype 3

# SPDX-License-Identifier: GPL-3.0-or-later
# relaxation_fit points states.csv > points.csv; gnuplot plot.gp   (writes relaxation.png)
set terminal pngcairo size 1000,440 font "sans,10" background "white"
set output "relaxation.png"
set datafile separator ","
set multiplot layout 1,2
set key left top
set xlabel "mechanical coordination number z*"
set xrange [3.9:8.8]
set yrange [0:1]
set ylabel "G / G(uniform strain), closed form"
points(ratio, column_) = sprintf("< awk -F, '$3==%s && $8==1' points.csv", ratio)
set style line 1 pt 7 ps 0.35 lc rgb "#1f77b4"
set style line 2 pt 7 ps 0.35 lc rgb "#d62728"
set style line 3 pt 7 ps 0.35 lc rgb "#2ca02c"
plot points("0.919", 0) u 2:4 ls 1 t "k_t/k_n = 0.92", points("0.1", 0) u 2:4 ls 2 t "0.1", \
     points("0", 0) u 2:4 ls 3 t "0", \
     points("0.919", 0) u 2:5 w p pt 7 ps 0.2 lc rgb "black" t "formula, each contact law", \
     points("0.1", 0) u 2:5 w p pt 7 ps 0.2 lc rgb "black" not, points("0", 0) u 2:5 w p pt 7 ps 0.2 lc rgb "black" not
set ylabel "K / K(uniform strain), closed form"
set yrange [0.4:1]
set key right bottom
plot "< awk -F, '$3==0.919 && $8==1 && $1==\"cone\"' points.csv" u 2:6 ls 1 t "cone, k_t/k_n = 0.92", \
     "< awk -F, '$3==0.919 && $8==1 && $1==\"sphere\"' points.csv" u 2:6 ls 2 t "sphere", \
     "< awk -F, '$3==0.919 && $8==1 && $1==\"flat\"' points.csv" u 2:6 ls 3 t "flat", \
     "< awk -F, '$3==0.919 && $8==1 && $1==\"alpha1.5\"' points.csv" u 2:6 pt 7 ps 0.35 lc rgb "#ff7f0e" t "alpha = 1.5", \
     points("0.919", 0) u 2:7 w p pt 7 ps 0.2 lc rgb "black" t "formula"
unset multiplot

# SPDX-License-Identifier: GPL-3.0-or-later
# contact_prior_fit points states.csv > points.csv; contact_prior_fit lines > lines.csv; gnuplot plot.gp
set terminal pngcairo size 1000,440 font "sans,10" background "white"
set output "contact_prior.png"
set datafile separator ","
set multiplot layout 1,2
set key right top
set style line 1 pt 7 ps 0.5 lc rgb "#1f77b4"
set style line 2 pt 7 ps 0.5 lc rgb "#d62728"
set style line 3 pt 7 ps 0.5 lc rgb "#2ca02c"
at(p, c) = sprintf("< awk -F, '$1==\"sphere\" && $3==%s && %s' points.csv", p, c)
gas = "($2 ~ /^gas/ || $2 == \"dense\")"
opened = "!($2 ~ /^gas/ || $2 == \"dense\")"
set xlabel "void ratio e, less what overlaps take"
set ylabel "mechanical coordination number z*"
set xrange [0.54:0.90]
set yrange [3.9:7.6]
plot "lines.csv" u 1:2 w l lw 2 lc rgb "#1f77b4" t "spheres at 10 kPa: densest line, friction 0.5", \
     "" u 1:3 w l lw 2 lc rgb "#1f77b4" not, \
     "" u 1:4 w l lw 2 lc rgb "#d62728" t "the same at 1 MPa", "" u 1:5 w l lw 2 lc rgb "#d62728" not, \
     at("10000", gas) u 4:5 ls 1 t "from a gas or without friction, 10 kPa", \
     at("10000", opened) u 4:5 w p pt 6 ps 0.6 lc rgb "#1f77b4" t "opened a little, with friction, 10 kPa", \
     at("1000000", gas) u 4:5 ls 2 t "from a gas or without friction, 1 MPa", \
     at("1000000", opened) u 4:5 w p pt 6 ps 0.6 lc rgb "#d62728" t "opened a little, 1 MPa", \
     "published.csv" every ::1 u 2:3 w p pt 8 ps 1.2 lc rgb "black" t "others, 10 and 50 kPa"
set xlabel "z* by the prior, recipe told"
set ylabel "z*"
set xrange [3.9:7.1]
set yrange [3.9:7.1]
set key left top
plot x w l lc rgb "gray" not, \
     "< awk -F, '$1==\"cone\"' points.csv" u 6:5 ls 1 t "cone", \
     "< awk -F, '$1==\"sphere\"' points.csv" u 6:5 ls 2 t "sphere", \
     "< awk -F, '$1==\"flat\"' points.csv" u 6:5 ls 3 t "flat", \
     "< awk -F, '$1==\"alpha1.5\"' points.csv" u 6:5 w p pt 7 ps 0.5 lc rgb "#ff7f0e" t "alpha = 1.5"
unset multiplot

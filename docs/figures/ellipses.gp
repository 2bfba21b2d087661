# The picture of docs/quadrature.md; see scripts/figures.
set terminal svg size 900,430 font "Helvetica,15" background "white"
set output picture

set size ratio -1
set xrange [-1.25:1.25]
set yrange [-0.46:0.46]
set lmargin 1
set rmargin 1
set tmargin 2.5
set bmargin 0.5
set border 0
unset xtics
unset ytics
set xzeroaxis lt 1 lw 1 lc rgb "#888888"
set key outside top center horizontal samplen 2.5 width 2 reverse Left

set label 1 "pole 1/3 + i/5" at 0.335,0.42 center tc rgb "#b03020"
set arrow 1 from 0.335,0.39 to 0.335,0.225 nohead lc rgb "#b03020"
set label 2 "pole 1/3 - i/5" at 0.335,-0.42 center tc rgb "#b03020"
set arrow 2 from 0.335,-0.385 to 0.335,-0.225 nohead lc rgb "#b03020"
set label 3 "proved by tiles" at -0.5,0.2 center front tc rgb "#20406a"
set label 4 "proved by reflection" at -0.5,-0.2 center front tc rgb "#20406a"
set label 5 "-1" at -1,-0.065 center
set label 6 "0" at 0,-0.065 center
set label 7 "1/4" at 0.25,-0.065 center
set label 8 "1/2" at 0.5,-0.065 center
set label 9 "1" at 1,-0.065 center

$poles << EOD
0.333333333 0.2
0.333333333 -0.2
EOD

plot data index 2 using 1:2:1:3:2:4 with boxxyerror fc rgb "#d6e6f5" fs solid border rgb "#8ab4dc" title "tiles", \
     data index 1 using 1:2 with lines lw 2 lc rgb "#20406a" title "Bernstein ellipses", \
     data index 3 using 1:2 with points pt 7 ps 0.3 lc rgb "#20406a" title "nodes", \
     data index 0 using 1:(-0.03):(0):(0.06) with vectors nohead lw 2 lc rgb "#000000" title "ends of panels", \
     $poles using 1:2 with points pt 2 ps 0.9 lw 2.5 lc rgb "#b03020" title "poles of the integrand"

# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of a cantilever of prisms against beam theory, by number of prisms; what restoring springs make of it.
#   gnuplot -c rain_prisms.gp FOLDER FILE LANGUAGE
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_prisms.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
PRISMS = DIR.'/tables/prisms.csv'
WIDTH = 640.0; HEIGHT = 250.0
load HERE.'start.gp'
set multiplot
set logscale x 2; set xrange [3.5:75]; set xlabel L('RAIN_PRISMS') offset 0,0.3
set lmargin at screen 84.0/WIDTH; set rmargin at screen 380.0/WIDTH
set tmargin at screen 1 - 24.0/HEIGHT; set bmargin at screen 52.0/HEIGHT
set logscale y; set yrange [5e-5:0.2]; set format y "%g"
set ylabel L('RAIN_ERROR') offset 1,0; set key bottom left
plot PRISMS using (column("prisms")):(abs(column("tip_error"))) with linespoints lt 1 title L('RAIN_TIP'), \
     '' using (column("prisms")):(abs(column("frequency_error"))) with linespoints lt 2 title L('RAIN_F1'), \
     0.4/x**2 with lines lc rgb '#909090' lw 1 dt (3,3) title L('RAIN_ORDER')
set lmargin at screen 470.0/WIDTH; set rmargin at screen 622.0/WIDTH
unset logscale y; set yrange [-0.35:1.1]; set ytics 0,0.2; set format y "%g"
set ylabel L('RAIN_OVER_THEORY') offset 1,0; set key bottom left font ',9.5' samplen 2
plot PRISMS using (column("prisms")):(1 + column("tip_error")) with linespoints lt 1 title L('RAIN_FREE'), \
     '' using (column("prisms")):(column("tip_with_restoring")) with linespoints lt 4 title L('RAIN_HELD_BACK')
unset multiplot
set output

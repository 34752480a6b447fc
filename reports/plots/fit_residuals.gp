# SPDX-License-Identifier: GPL-3.0-or-later
# Residuals over sigma in the order of the readings, and their influence on the estimates.
#   gnuplot -c fit_residuals.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'fit_residuals.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
GROUPS = int(number('GROUPS', 0))
READINGS = DIR.'/tables/readings.csv'
KEYS = GROUPS <= 6 ? (GROUPS + 1)/2 : 0
WIDTH = 640.0; HEIGHT = 330.0 + 18.0*KEYS
in(g) = column("group") == g
stats READINGS using (abs(column("residual"))) nooutput
TOP = STATS_max > 3 ? 1.1*STATS_max : 3.0
load HERE.'start.gp'
set multiplot
set lmargin at screen 72.0/WIDTH; set rmargin at screen 628.0/WIDTH
set tmargin at screen 320.0/HEIGHT; set bmargin at screen 196.0/HEIGHT
set xrange [0:STATS_records + 1]; set yrange [-TOP:TOP]
set ylabel L('RESIDUAL') offset 1,0
set format x ''
if (KEYS) { set key at screen 0.5, screen 1.0 center top horizontal } else { unset key }
set object 1 rectangle from graph 0, first -1.96 to graph 1, first 1.96 fs solid 0.12 noborder fc rgb '#0072B2' behind
plot for [g=1:GROUPS] READINGS using ($0 + 1):(pick(in(g), column("residual"))) with points lt ((g - 1)%6 + 1) lw 1 title short(text_of('GROUP', g), 250), 0 with lines lt 1 lc rgb '#404040' lw 0.7 notitle
unset object 1; unset key
set format x '%g'
set tmargin at screen 164.0/HEIGHT; set bmargin at screen 52.0/HEIGHT
set xlabel L('READING'); set ylabel L('INFLUENCE') offset 1,0
set yrange [0:*]
plot for [g=1:GROUPS] READINGS using ($0 + 1):(pick(in(g), column("influence_sd"))) with impulses lt ((g - 1)%6 + 1) dt 1 lw 1.5
unset multiplot
set output

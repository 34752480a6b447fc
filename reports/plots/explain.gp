# SPDX-License-Identifier: GPL-3.0-or-later
# What each method finds for the bending of every branch, over beam theory; 1 is agreement.
#   gnuplot -c explain.gp FOLDER [FILE [LANGUAGE [RUN]]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'explain.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
SHOWN = ARGC > 3 ? int(ARG4) : 1
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
METHODS = int(number('METHODS', 0)); FIRST = int(number('FIRST', 0)); EXPLAIN_LEVELS = int(number('EXPLAIN_LEVELS', 0))
LOW = number('LOW', 0); HIGH = number('HIGH', 0)
EXPLAIN = DIR.'/tables/explain.csv'
WIDTH = 640.0; KEY = 24.0 + 20.0*ceil(METHODS/3.0); HEIGHT = 270.0 + KEY
set linetype 7 lc rgb '#000000' pt 2 ps 0.7
load HERE.'start.gp'
set multiplot
set lmargin at screen 84.0/WIDTH; set rmargin at screen 625.0/WIDTH
set tmargin at screen 1 - 14.0/HEIGHT; set bmargin at screen (KEY + 52)/HEIGHT
set logscale y
set yrange [LOW:HIGH]; set xrange [-0.5:EXPLAIN_LEVELS - 0.5]
set xtics 1; set xlabel L('EXPLAIN_LEVEL'); set ylabel L('EXPLAIN_RATIO') offset 1.5,0
set arrow 1 from -0.5,1 to EXPLAIN_LEVELS - 0.5,1 nohead lc rgb '#404040' lw 1
set format y "%g"; set ytics add ("0.00001" 1e-5, "0.000001" 1e-6, "0.0000001" 1e-7)
LIST = ''
do for [m=1:METHODS] { a = number(sprintf('ANSWERS_%d', SHOWN), m); if (a == a) { LIST = LIST.sprintf('%d ', a) } }
M(k) = nth(LIST, k)
plot for [k=1:words(LIST)] EXPLAIN using (pick(column("run") == SHOWN, column("level")) + (M(k) - 0.5*(METHODS + 1))*0.8/METHODS):(column(FIRST + M(k))) with points lt M(k)
load HERE.'strip.gp'
set key maxcols 3 samplen 1 width 0
plot for [m=1:METHODS] -1 with points lt m title text_of('METHOD', m)
unset multiplot
set output

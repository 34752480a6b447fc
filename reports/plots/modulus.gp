# SPDX-License-Identifier: GPL-3.0-or-later
# Deflection of the tip by the modulus, over the runs that differ in nothing else.
#   gnuplot -c modulus.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'modulus.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'series_facts.gp'
WIDTH = 640.0; HEIGHT = 250.0
array SWEPT[RUNS]
do for [k=1:RUNS] { SWEPT[k] = number('SWEPT', k) }
swept(r) = (sum [k=1:RUNS] (SWEPT[k] == r ? 1 : 0)) > 0
set table $SWEEP separator comma
plot DIR.'/tables/runs.csv' using (per('GPa')*column("youngs_modulus_Pa")/1e9):(PER_M*column("tip_deflection_mean_m")) with table if (swept(column("run")))
unset table
set datafile nocolumnheaders
load HERE.'start.gp'
unset key
set lmargin at screen 70.0/WIDTH; set rmargin at screen 600.0/WIDTH
set xlabel L('YOUNGS'); set ylabel L('TIP_M')
set offsets 0.5*per('GPa'), 0.5*per('GPa'), 0, 0; set yrange [0:*]
plot $SWEEP using 1:2 smooth unique with linespoints lt 1
set output

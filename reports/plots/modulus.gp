# Deflection of the tip by the modulus, over the runs that differ in nothing else.
#   gnuplot -c modulus.gp FOLDER [FILE]     plots/run.gp: SWEPT = numbers of the runs
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'modulus.svg'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
WIDTH = 640.0; HEIGHT = 250.0
swept(r) = strstrt(" ".SWEPT, sprintf(" %d ", r)) > 0
set table $SWEEP separator comma
plot DIR.'/tables/runs.csv' using (column("youngs_modulus_Pa")/1e9):(column("tip_deflection_mean_m")) with table if (swept(column("run")))
unset table
set datafile nocolumnheaders
@start
unset key
set lmargin at screen 70.0/WIDTH; set rmargin at screen 600.0/WIDTH
set xlabel "Young's modulus (GPa)"; set ylabel "tip deflection (m)"
set offsets 0.5, 0.5, 0, 0; set yrange [0:*]
plot $SWEEP using 1:2 smooth unique with linespoints lt 1
set output

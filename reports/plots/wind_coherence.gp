# SPDX-License-Identifier: GPL-3.0-or-later
# Coherence of the along-wind part between the first point and the others, against the one asked for.
#   gnuplot -c wind_coherence.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'wind_coherence.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
PAIRS = int(number('PAIRS', 0)); TARGET = number('TARGET', 0) == 1
COHERENCE = DIR.'/tables/coherence.csv'
FEW = PAIRS < 5 ? PAIRS : 5
which(i) = PAIRS < 6 ? i : 1 + int((i - 1)*(PAIRS - 1)/4.0 + 0.5)
array APART[FEW]
do for [i=1:FEW] {
    stats COHERENCE using (pick(column("point") == which(i) + 1, column("distance_m"))) nooutput
    APART[i] = STATS_max
}
WIDTH = 640.0; KEY = 24.0; HEIGHT = 310.0 + KEY
load HERE.'start.gp'
set multiplot
set tmargin at screen 1 - 26.0/HEIGHT; set bmargin at screen (52.0 + KEY)/HEIGHT
set lmargin at screen 60.0/WIDTH; set rmargin at screen 626.0/WIDTH
set title L('COHERENCE') offset 0,-0.6
set logscale x; set format x "%g"
set xlabel L('FREQUENCY'); set ylabel L('ROOT_COHERENCE') offset 1,0
set yrange [-0.3:1.05]
unset key
plot for [i=1:FEW] COHERENCE using (pick(column("point") == which(i) + 1, column("frequency_hz"))):(column("coherence")) with points lt i lw 1, \
     for [i=1:(TARGET ? FEW : 0)] COHERENCE using (pick(column("point") == which(i) + 1, column("frequency_hz"))):(column("target")) with lines lt i
load HERE.'strip.gp'
plot 2 with lines, for [i=1:FEW] keyentry with linespoints lt i title typed(APART[i], 'm')
unset multiplot
set output

# SPDX-License-Identifier: GPL-3.0-or-later
# Wind and tip deflection in time, run by run. Runs of a single frame have no course in time and are left out.
#   gnuplot -c series.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'series.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
load HERE.'series_facts.gp'
SERIES = DIR.'/tables/series.csv'
MOVING = ""
do for [r=1:RUNS] { if (FRAMES[r] > 1) { MOVING = MOVING.r." " } }
WIDTH = 640.0; KEY = 30.0 + 17.0*ceil(words(MOVING)/2.0)
ROW = 112.0; HEIGHT = 2*(ROW + 12) + 52 + KEY
of(r) = column("run") == r
SPAN = 0.0
do for [r=1:RUNS] { SPAN = FRAMES[r]*STEP[r] > SPAN && FRAMES[r] > 1 ? FRAMES[r]*STEP[r] : SPAN }
# a steady wind draws a level line, whose range gnuplot would find empty: room above and below it
level(low, high) = high - low <= 1e-9*abs(high)
below(low) = low - 0.1*abs(low) - 1e-9
above(high) = high + 0.1*abs(high) + 1e-9
stats SERIES using (PER_MS*column("wind_m_s")) name "WIND" nooutput
stats SERIES using (PER_M*column("tip_deflection_m")) name "TIP" nooutput
load HERE.'start.gp'
set multiplot
set lmargin at screen 82.0/WIDTH; set rmargin at screen 625.0/WIDTH
set xrange [0:SPAN]
set tmargin at screen 1 - 12.0/HEIGHT; set bmargin at screen 1 - (12 + ROW)/HEIGHT
set ylabel L('WIND_MS'); set format x ""
if (level(WIND_min, WIND_max)) { set yrange [below(WIND_min):above(WIND_max)] } else { set yrange [*:*] }
plot for [c=1:words(MOVING)] SERIES using (pick(of(nth(MOVING, c)), column("time_s"))):(PER_MS*column("wind_m_s")) with lines lt c lw 1.2
set format x "%g"
set tmargin at screen 1 - (24 + ROW)/HEIGHT; set bmargin at screen 1 - (24 + 2*ROW)/HEIGHT
set ylabel L('TIP_M') offset 1.2,0; set xlabel L('TIME')
if (level(TIP_min, TIP_max)) { set yrange [below(TIP_min):above(TIP_max)] } else { set yrange [*:*] }
plot for [c=1:words(MOVING)] SERIES using (pick(of(nth(MOVING, c)), column("time_s"))):(PER_M*column("tip_deflection_m")) with lines lt c lw 1.2, \
     for [c=1:words(MOVING)] SERIES using (pick(of(nth(MOVING, c)) && column("beyond_breakage") == 1, column("time_s"))):(PER_M*column("tip_deflection_m")) with lines lc rgb '#ffffff' dt 1 lw 2.2, \
     for [c=1:words(MOVING)] SERIES using (pick(of(nth(MOVING, c)) && column("beyond_breakage") == 1, column("time_s"))):(PER_M*column("tip_deflection_m")) with lines lt c lc rgb '#a0a0a0' lw 1.2
load HERE.'strip.gp'
set key maxcols 2
plot for [c=1:words(MOVING)] -1 with lines lt c title short(NAME[nth(MOVING, c)], 230)
unset multiplot
set output

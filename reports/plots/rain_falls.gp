# SPDX-License-Identifier: GPL-3.0-or-later
# Terminal speed of drops by five laws, and drops in the air at 10 mm/h by Marshall and Palmer.
#   gnuplot -c rain_falls.gp FOLDER FILE LANGUAGE
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_falls.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
FALLS = DIR.'/tables/falls.csv'
WIDTH = 640.0; HEIGHT = 240.0
array LAW[5] = ['atlas', 'brandes', 'van-dijk', 'uplinger', 'lhermitte']
load HERE.'start.gp'
set multiplot
set tmargin at screen 1 - 14.0/HEIGHT; set bmargin at screen 52.0/HEIGHT
set xrange [0:6*PER_MM]; set xlabel L('RAIN_DIAMETER') offset 0,0.3
set lmargin at screen 62.0/WIDTH; set rmargin at screen 350.0/WIDTH
set yrange [0:10*PER_MS]; set ylabel L('RAIN_SPEED') offset 1,0; set key bottom right
plot for [k=1:5] FALLS using (PER_MM*column("diameter_mm")):(PER_MS*column(LAW[k].'_m_s')) with lines lt k lw 1.2 title L('FALL_'.LAW[k])
set lmargin at screen 440.0/WIDTH; set rmargin at screen 622.0/WIDTH
set logscale y; set yrange [0.01:20000]; set format y "%g"
set ylabel L('RAIN_NUMBER') offset 1,0 font ',9.5'; unset key
plot FALLS using (PER_MM*column("diameter_mm")):(column("number_m3_mm")) with lines lt 1
unset multiplot
set output

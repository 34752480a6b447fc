# SPDX-License-Identifier: GPL-3.0-or-later
# Share of hours with a stronger wind: counted in a record, and by the Weibull distributions fitted to it.
#   gnuplot -c rose_record.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rose_record.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
EXCEEDED = DIR.'/tables/exceedance.csv'
WIDTH = 640.0; HEIGHT = 320.0
load HERE.'start.gp'
set lmargin at screen 82.0/WIDTH; set rmargin at screen 625.0/WIDTH
stats EXCEEDED using "share_counted" nooutput
set logscale y
set yrange [0.3*STATS_min:1]
set format y "%g"
set xlabel L('WIND_MS'); set ylabel L('SHARE_ABOVE')
set key top right
plot EXCEEDED using (PER_MS*column("speed_m_s")):"share_fitted" with lines lw 1.4 title L('ROSE_FITTED'), \
     EXCEEDED using (PER_MS*column("speed_m_s")):"share_counted" with points pt 7 ps 0.35 lc rgb '#404040' title L('ROSE_COUNTED')
set output

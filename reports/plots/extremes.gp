# SPDX-License-Identifier: GPL-3.0-or-later
# Winds by return period: the distribution, its band, and the annual maxima it was fitted to.
#   gnuplot -c extremes.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'extremes.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
LEVELS = DIR.'/tables/extremes.csv'; YEARS = DIR.'/tables/annual.csv'; CURVE = DIR.'/plots/extremes_curve.csv'
SAMPLE = number('SAMPLE', 0); END = number('END', 0); WINDS = int(number('WINDS', 0))
WIDTH = 640.0; HEIGHT = 240.0
load HERE.'start.gp'
set tmargin at screen 1 - 14.0/HEIGHT; set bmargin at screen 52.0/HEIGHT
set lmargin at screen 60.0/WIDTH; set rmargin at screen 626.0/WIDTH
set logscale x
set xrange [1.02:END]
set xtics (2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
set xlabel L('RETURN_PERIOD'); set ylabel sprintf(L('WIND'), typed(10, 'm')) offset 1,0
set key bottom right Left reverse
do for [k=1:WINDS] {
    set arrow from 1.02,PER_MS*number('WIND', k) to END,PER_MS*number('WIND', k) nohead lw 1 lc rgb '#404040' dt (2,3) back
}
if (SAMPLE) {
    plot LEVELS using "return_period_years":(PER_MS*column("low_m_s")):(PER_MS*column("high_m_s")) with filledcurves lc rgb '#c7dcec' title L('SHARE_BAND'), \
         CURVE using "return_period_years":(PER_MS*column("speed_m_s")) with lines lt 1 title L('EXTREME_FIT'), \
         YEARS using "return_period_years":(PER_MS*column("speed_m_s")) with points pt 6 ps 0.6 lc rgb '#202020' title L('EXTREME_YEARS')
} else {
    plot CURVE using "return_period_years":(PER_MS*column("speed_m_s")) with lines lt 1 title L('EXTREME_FIT')
}
set output

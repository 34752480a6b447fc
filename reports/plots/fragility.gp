# SPDX-License-Identifier: GPL-3.0-or-later
# Share of the samples that are lost by a mean wind, with its band and the lognormal law.
#   gnuplot -c fragility.gp FOLDER [FILE [LANGUAGE [RUN]]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'fragility.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
CURVE = DIR.'/tables/fragility.csv'
LOW = PER_MS*number('LOW', 0); HIGH = PER_MS*number('HIGH', 0); END = PER_MS*number('END', 0); FIT = number('FIT', 0)
WIDTH = 640.0; HEIGHT = 330.0
load HERE.'start.gp'
set tmargin at screen 1 - 14.0/HEIGHT; set bmargin at screen 52.0/HEIGHT
set lmargin at screen 60.0/WIDTH; set rmargin at screen 626.0/WIDTH
set xlabel sprintf(L('WIND'), typed(number('REFERENCE', 0), 'm')); set ylabel L('SHARE_LOST') offset 1,0
set xrange [0:END]; set yrange [0:100]
set key top left Left reverse opaque
if (LOW == LOW) { set arrow from LOW,0 to LOW,100 nohead lw 1 lc rgb '#404040' dt (2,3) back }
if (HIGH == HIGH) { set arrow from HIGH,0 to HIGH,100 nohead lw 1 lc rgb '#404040' dt (2,3) back }
plot CURVE using (PER_MS*column("wind_m_s")):(100*column("share_low")):(100*column("share_high")) with filledcurves lc rgb '#c7dcec' title L('SHARE_BAND'), \
     CURVE using (PER_MS*column("wind_m_s")):(100*column("share_lost")) with steps lt 1 title L('SHARE_SAMPLES'), \
     CURVE using (FIT == FIT ? PER_MS*column("wind_m_s") : NaN):(100*column("lognormal")) with lines lt 2 title L('SHARE_LAW')
set output

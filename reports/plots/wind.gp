# SPDX-License-Identifier: GPL-3.0-or-later
# A gusty wind: the first ten minutes, its spectrum against the target, its histogram.
#   gnuplot -c wind.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'wind.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
MODEL = text_of('MODEL', 0); DURATION = number('DURATION', 0); STEP = number('STEP', 0)
COMPONENTS = int(number('COMPONENTS', 0)); TARGET = number('TARGET', 0) == 1
SERIES = DIR.'/tables/series.csv'
SPECTRUM = DIR.'/tables/spectrum.csv'
HISTOGRAM = DIR.'/tables/histogram.csv'
array COMPONENT[3] = ['along', 'across', 'up']
WIDTH = 640.0; KEY = COMPONENTS > 1 ? 24.0 : 0.0; HEIGHT = 490.0 + KEY
stats SPECTRUM using (column("frequency_hz")*column("density_m2_s")) nooutput
TOP = STATS_max
stats HISTOGRAM using (PER_MS*column(1)) nooutput
# three or four ticks across the narrow panel
SPAN = (STATS_max - STATS_min)/3.0; TEN = 10.0**floor(log10(SPAN))
TICK = SPAN/TEN > 5 ? 5*TEN : SPAN/TEN > 2 ? 2*TEN : TEN
SHOWN = DURATION < 600 ? DURATION : 600
EVERY = ceil(SHOWN/STEP/3000.0)

load HERE.'start.gp'
set multiplot
set lmargin at screen 84.0/WIDTH; set rmargin at screen 618.0/WIDTH
set tmargin at screen 1 - 26.0/HEIGHT; set bmargin at screen 1 - 170.0/HEIGHT
set title sprintf(L('WIND_FIRST'), MODEL, sprintf('%g', SHOWN)) offset 0,-0.6
set xrange [0:SHOWN]; set yrange [*:*]
set xlabel L('TIME'); set ylabel L('WIND_MS') offset 1,0
unset key
plot for [c=COMPONENTS:1:-1] SERIES every EVERY using 1:(PER_MS*column(c + 1)) with lines lt c lw 0.8 dt 1

set lmargin at screen 84.0/WIDTH; set rmargin at screen 384.0/WIDTH
set tmargin at screen 1 - 248.0/HEIGHT; set bmargin at screen (52.0 + KEY)/HEIGHT
set title (TARGET ? L('SPECTRUM_TARGET') : L('SPECTRUM')) offset 0,-0.6
PER_F_S = per('m²/s²')
set logscale xy; set xrange [*:*]; set yrange [3e-5*PER_F_S*TOP:*]
set format xy "%g"
set xlabel L('FREQUENCY'); set ylabel L('F_S') offset 0,0
is(c) = strcol("component") eq COMPONENT[c]
plot for [c=1:COMPONENTS] SPECTRUM using (pick(is(c), column("frequency_hz"))):(PER_F_S*column("frequency_hz")*column("density_m2_s")) with points lt c lw 1, \
     for [c=1:(TARGET ? COMPONENTS : 0)] SPECTRUM using (pick(is(c), column("frequency_hz"))):(PER_F_S*column("frequency_hz")*column("target_m2_s")) with lines lt c

unset logscale; set format xy "%g"
set lmargin at screen 462.0/WIDTH; set rmargin at screen 618.0/WIDTH
set title L('HISTOGRAM') offset 0,-0.6
set xrange [*:*]; set yrange [0:*]
set xlabel L('WIND_MS'); set ylabel sprintf(L('SHARE'), unit('m/s')) offset 0,0
set xtics TICK
plot HISTOGRAM using (PER_MS*column(1)):(column(2)/PER_MS) with boxes fs solid 0.35 noborder lt 1, HISTOGRAM using (PER_MS*column(1)):(column(3)/PER_MS) with lines lt 2
if (KEY > 0) {
    load HERE.'strip.gp'
    plot 2 with lines, for [c=1:COMPONENTS] keyentry with linespoints lt c title L(sprintf('COMPONENT_%d', c))
}
unset multiplot
set output

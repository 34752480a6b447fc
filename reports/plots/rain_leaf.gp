# SPDX-License-Identifier: GPL-3.0-or-later
# One leaf in the key frames of a run: wetness, and the drops on it by state; subdrops trail behind those that run.
#   gnuplot -c rain_leaf.gp FOLDER FILE LANGUAGE RUN
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_leaf.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'; RUN = ARGC > 3 ? int(ARG4) : 1
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
KEYS = int(number('KEYS', RUN)); LENGTH = PER_MM*number('LENGTH', RUN); HALF = PER_MM*number('HALF', RUN)
map(k) = DIR.sprintf('/tables/map_%d_%d.csv', RUN, k); DROPS = DIR.'/tables/drops.csv'
WIDTH = 640.0; DOWN = ceil(KEYS/3.0); KEY = 24.0
PANEL = 175.0; TALL = PANEL*2.1*HALF/(1.04*LENGTH); TALL = TALL < 40 ? 40.0 : TALL
HEIGHT = DOWN*(TALL + 46.0) + 34.0 + KEY
load HERE.'start.gp'
set multiplot
unset key; unset grid; set border 3 lw 0.5
set xrange [-0.02*LENGTH:1.02*LENGTH]; set yrange [-1.05*HALF:1.05*HALF]
TICK = PER_MM == 1 ? 20.0 : PER_MM < 0.05 ? 1.0 : 2.0
set xtics TICK font ',9.5'; set ytics TICK font ',9.5'; set format x "%g"
# from dry to wet; transparent beside the blade
array DRY[3] = [233, 242, 223]; array WET[3] = [63, 125, 79]
beside(text) = strlen(text) == 0
mix(c) = beside(strcol(3)) ? 255 : DRY[c] + (WET[c] - DRY[c])*column(3)
event(k) = L('RAIN_'.text_of(sprintf('EVENT_%d', RUN), k))
here(k) = column("run") == RUN && column("key") == k
is(what) = strcol("state") eq what
array STATE[3] = ['rest', 'run', 'hang']; array COLOUR[3] = ['#0072B2', '#D55E00', '#CC79A7']
do for [k=1:KEYS] {
    i = (k - 1) % 3; j = (k - 1)/3
    x0 = 48.0 + i*(PANEL + 12.0); y0 = 22.0 + j*(TALL + 46.0)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + PANEL)/WIDTH
    set tmargin at screen 1 - y0/HEIGHT; set bmargin at screen 1 - (y0 + TALL)/HEIGHT
    set title sprintf(L('RAIN_LEAF_AT'), event(k), number(sprintf('TIME_%d', RUN), k), int(number(sprintf('LEAF_%d', RUN), k))) offset 0,-0.7 font ',9.5'
    if (i == 0) { set format y "%g"; set ylabel L('RAIN_ACROSS') offset 1.5,0 font ',9.5' } else { set format y ""; set ylabel "" }
    if (j == DOWN - 1) { set xlabel L('RAIN_ALONG') offset 0,0.6 } else { set xlabel "" }
    plot map(k) using (PER_MM*$1):(PER_MM*$2):(mix(1)):(mix(2)):(mix(3)):(beside(strcol(3)) ? 0 : 255) with rgbalpha, \
         for [s=1:3] DROPS using (pick(here(k) && is(STATE[s]), PER_MM*column("along_mm"))):(PER_MM*column("across_mm")):(PER_MM*column("base_mm")) with circles fs transparent solid 0.35 border lc rgb COLOUR[s]
}
load HERE.'strip.gp'
set xrange [0:1]; set yrange [0:1]
plot for [s=1:3] NaN with points pt 7 ps 0.9 lc rgb COLOUR[s] title L('RAIN_'.STATE[s])
unset multiplot
set output

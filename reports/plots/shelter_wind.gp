# SPDX-License-Identifier: GPL-3.0-or-later
# Speed over the undisturbed speed on a level and an upright cut; the wind blows from left to right.
#   gnuplot -c shelter_wind.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'shelter_wind.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
LEFT = PER_M*number('LEFT', 0); WIDE = PER_M*number('WIDE', 0); BOTTOM = PER_M*number('BOTTOM', 0); TALL = PER_M*number('TALL', 0); DEPTH = PER_M*number('DEPTH', 0)
FRONT = PER_M*number('FRONT', 0); CUT_UP = number('CUT_UP', 0); CUT_ACROSS = number('CUT_ACROSS', 0); LAW = text_of('LAW', 0)
LEVEL = DIR.'/tables/cut_level.csv'
UPRIGHT = DIR.'/tables/cut_upright.csv'
WIDTH = 640.0
LONG = 216.0; APART = 296.0   # the two cuts side by side, on one scale of colours
FROM = FRONT - 0.15*DEPTH; LENGTH = 2.1*DEPTH
fit(h) = h > 196 ? 196.0 : h < 70 ? 70.0 : h
H1 = fit(LONG*WIDE/LENGTH); H2 = fit(LONG*TALL/LENGTH)
TALLER = H1 > H2 ? H1 : H2; HEIGHT = TALLER + 100.0
stats LEVEL using (column("ratio")) nooutput
LOW = STATS_min; HIGH = STATS_max
stats UPRIGHT using (column("ratio")) nooutput
LOW = LOW < STATS_min ? LOW : STATS_min; HIGH = HIGH > STATS_max ? HIGH : STATS_max
SPAN = HIGH - 1 > 1 - LOW ? HIGH - 1 : 1 - LOW
SPAN = SPAN < 0.02 ? 0.02 : SPAN
FASTER = HIGH > 1.02
load HERE.'start.gp'
set multiplot
unset key; unset grid
set border 15 lw 0.6
# blue slower than the undisturbed wind, red faster
set palette defined (-1 '#053061', -0.5 '#4393c3', 0 '#f7f7f7', 0.5 '#d6604d', 1 '#67001f')
if (FASTER) { set cbrange [1-SPAN:1+SPAN] } else { set palette defined (-1 '#053061', -0.5 '#4393c3', 0 '#f7f7f7'); set cbrange [1-SPAN:1] }
set xrange [FROM:FROM+LENGTH]
do for [i=1:2] {
    y0 = 44.0; x0 = 58.0 + (i - 1)*APART
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + LONG)/WIDTH
    set tmargin at screen 1 - y0/HEIGHT; set bmargin at screen 1 - (y0 + (i == 1 ? H1 : H2))/HEIGHT
    if (i == 1) { unset colorbox } else { set colorbox vertical user origin (x0 + LONG + 10)/WIDTH, 1 - (y0 + H2)/HEIGHT size 10.0/WIDTH, H2/HEIGHT }
    set title two_lines((i == 1 ? sprintf(L('CUT_LEVEL'), LAW, three(CUT_UP, 'm')) : sprintf(L('CUT_UPRIGHT'), three(CUT_ACROSS, 'm'))), LONG + 40) offset 0,-0.6
    set xlabel L('ALONG_M') offset 0,0.4
    set arrow 1 from first FRONT, graph 0 to first FRONT, graph 1 nohead front lw 0.6 lc rgb '#707070' dt (4,3)
    set arrow 2 from first FRONT+DEPTH, graph 0 to first FRONT+DEPTH, graph 1 nohead front lw 0.6 lc rgb '#707070' dt (4,3)
    if (i == 1) {
        set ylabel L('ACROSS_M') offset 1,0; set yrange [LEFT:LEFT+WIDE]
        plot LEVEL using (PER_M*column("along_m")):(PER_M*column("across_m")):(column("ratio")) with image
    } else {
        set ylabel L('HEIGHT_M') offset 1,0; set yrange [BOTTOM:BOTTOM+TALL]
        plot UPRIGHT using (PER_M*column("along_m")):(PER_M*column("up_m")):(column("ratio")) with image
    }
}
unset multiplot
set output

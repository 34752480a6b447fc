# SPDX-License-Identifier: GPL-3.0-or-later
# Ground, shelter by it and wind over it, as maps and place by place.
#   gnuplot -c terrain.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'terrain.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
FROM = number('FROM', 0)
TERRAIN = DIR.'/tables/terrain.csv'
stats TERRAIN using (column("x_m")):(column("y_m")) nooutput
XLOW = STATS_min_x; XHIGH = STATS_max_x; YLOW = STATS_min_y; YHIGH = STATS_max_y
stats TERRAIN using (column("wind_factor")) nooutput
POINTS = STATS_records; FLOW = STATS_min; FHIGH = STATS_max
stats TERRAIN using (column("height_m")) nooutput
ZLOW = STATS_min; ZHIGH = STATS_max
stats TERRAIN using (column("topex_deg")) nooutput
TLOW = STATS_min; THIGH = STATS_max; TMEAN = STATS_mean; TWIDE = 2.5*STATS_stddev
WIDTH = 640.0
MAP = 250.0; TALL = MAP*(YHIGH - YLOW)/(XHIGH - XLOW)
TALL = TALL > 600 ? 600.0 : TALL < 60 ? 60.0 : TALL
HEIGHT = 2*TALL*215/250 + 176.0
load HERE.'start.gp'
set multiplot
unset grid; unset key
set border 15 lw 0.6
set format xy "%g"
# the maps are pictures inside the file: about 100 points a side and 16 colours keep it small
set palette maxcolors 16
SIDE = 1 + int((sqrt(POINTS) - 1)/100)
km(v) = v/1000.0
# four or five ticks a side; palettes run from light to dark, so that a copy in black and white can be read
SPAN = km(XHIGH - XLOW)/4.0; TEN = 10.0**floor(log10(SPAN))
TICK = SPAN/TEN > 5 ? 5*TEN : SPAN/TEN > 2 ? 2*TEN : TEN
set xtics TICK; set ytics TICK
set xrange [km(XLOW):km(XHIGH)]; set yrange [km(YLOW):km(YHIGH)]
set xlabel L('EAST_KM') offset 0,0.3
array TITLE[3] = [L('TERRAIN_HEIGHT'), L('TERRAIN_TOPEX'), sprintf(L('TERRAIN_FACTOR'), sprintf('%g', FROM))]
array NAMES[3] = ["height_m", "topex_deg", "wind_factor"]
do for [i=1:3] {
    col = (i - 1) % 2; row = (i - 1)/2
    x0 = 52.0 + col*306.0; y1 = 26.0 + row*(TALL*215/250 + 76.0)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + 215)/WIDTH
    set tmargin at screen 1 - y1/HEIGHT; set bmargin at screen 1 - (y1 + TALL*215/250)/HEIGHT
    set colorbox vertical user origin (x0 + 221)/WIDTH, 1 - (y1 + TALL*215/250)/HEIGHT size 9.0/WIDTH, TALL*215/250/HEIGHT
    set title TITLE[i] offset 0,-0.6
    if (col == 0) { set ylabel L('NORTH_KM') offset 1,0 } else { set ylabel "" }
    set cbrange [*:*]
    if (i == 1) { set palette defined (0 '#1f4e3d', 1 '#6f9f6e', 2 '#d3cb9a', 3 '#f7f3e8') }
    if (i == 2) { set palette defined (0 '#f7fbff', 1 '#6baed6', 2 '#08306b'); set cbrange [TMEAN-TWIDE:TMEAN+TWIDE] }
    if (i == 3) { set palette defined (0 '#fff7ec', 1 '#fdbb84', 2 '#7f0000') }
    # level ground has one colour: a range around its value
    if (i == 1 && ZLOW == ZHIGH) { set cbrange [ZLOW-1:ZHIGH+1] }
    if (i == 2 && TWIDE == 0) { set cbrange [TMEAN-1:TMEAN+1] }
    if (i == 3 && FLOW == FHIGH) { set cbrange [FLOW-0.1:FHIGH+0.1] }
    plot TERRAIN using (km(column("x_m"))):(km(column("y_m"))):(column(NAMES[i])) every SIDE:SIDE with image
}
set lmargin at screen 384.0/WIDTH; set rmargin at screen 618.0/WIDTH
set border 3; set grid lw 0.5 lt 1 lc rgb '#e3e3e3' dt 1
set title L('EACH_PLACE')
set xtics autofreq; set ytics autofreq
set xlabel L('TOPEX'); set ylabel L('WIND_LEVEL') offset 1,0
set xrange [TLOW-(TLOW == THIGH):THIGH+(TLOW == THIGH)]; set yrange [FLOW-0.1*(FLOW == FHIGH):FHIGH+0.1*(FLOW == FHIGH)]
EVERY = 1 + int(POINTS/300)
plot TERRAIN using (int(column(0)) % EVERY ? NaN : column("topex_deg")):(column("wind_factor")) with points lt 1 pt 7 ps 0.2
unset multiplot
set output

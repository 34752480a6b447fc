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
POINTS = STATS_records
stats TERRAIN using (column("wind_factor")) nooutput
FLOW = STATS_min; FHIGH = STATS_max
stats TERRAIN using (PER_M*column("height_m")) nooutput
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
# the maps are pictures inside the file: about 80 points a side, 16 colours and scales of 16 boxes (gnuplot's own
# have 128) keep it below 100 KB
set palette maxcolors 16
unset colorbox
SIDE = 1 + int((sqrt(POINTS) - 1)/80)
# few points are drawn as squares: as a picture they would be blurred, and shifted by half a square
SQUARES = POINTS <= 300
km(v) = PER_KM*v/1000.0
# a point is a square about it: the maps end half a square beyond the outermost points
SPAN_X = XHIGH - XLOW; SPAN_Y = YHIGH - YLOW
EDGE = POINTS > 1 && SPAN_X*SPAN_Y > 0 ? SIDE*SPAN_X*SPAN_Y/(sqrt((SPAN_X + SPAN_Y)**2 + 4*SPAN_X*SPAN_Y*(POINTS - 1)) - SPAN_X - SPAN_Y) : 0
# four or five ticks a side; palettes run from light to dark, so that a copy in black and white can be read
ten(span) = 10.0**floor(log10(span))
step(span) = span/ten(span) > 5 ? 5*ten(span) : span/ten(span) > 2 ? 2*ten(span) : ten(span)
TICK = step(km(XHIGH - XLOW)/4.0)
array TITLE[3] = [L('TERRAIN_HEIGHT'), L('TERRAIN_TOPEX'), sprintf(L('TERRAIN_FACTOR'), sprintf('%g', FROM))]
array PER_MAP[3] = [PER_M, 1.0, 1.0]
array NAMES[3] = ["height_m", "topex_deg", "wind_factor"]
do for [i=1:3] {
    col = (i - 1) % 2; row = (i - 1)/2
    x0 = 52.0 + col*306.0; y1 = 26.0 + row*(TALL*215/250 + 76.0)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + 215)/WIDTH
    set tmargin at screen 1 - y1/HEIGHT; set bmargin at screen 1 - (y1 + TALL*215/250)/HEIGHT
    set title TITLE[i] offset 0,-0.6
    if (col == 0) { set ylabel L('NORTH_KM') offset 1.9,0 } else { set ylabel "" }
    set cbrange [*:*]
    if (i == 1) { set palette defined (0 '#1f4e3d', 1 '#6f9f6e', 2 '#d3cb9a', 3 '#f7f3e8') }
    if (i == 2) { set palette defined (0 '#f7fbff', 1 '#6baed6', 2 '#08306b'); set cbrange [TMEAN-TWIDE:TMEAN+TWIDE] }
    if (i == 3) { set palette defined (0 '#fff7ec', 1 '#fdbb84', 2 '#7f0000') }
    # level ground has one colour: a range around its value
    if (i == 1 && ZLOW == ZHIGH) { set cbrange [ZLOW-1:ZHIGH+1] }
    if (i == 2 && TWIDE == 0) { set cbrange [TMEAN-1:TMEAN+1] }
    if (i == 3 && FLOW == FHIGH) { set cbrange [FLOW-0.1:FHIGH+0.1] }
    set xrange [km(XLOW - EDGE):km(XHIGH + EDGE)]; set yrange [km(YLOW - EDGE):km(YHIGH + EDGE)]
    set xtics border nomirror out scale 0.6 TICK; set ytics border nomirror out scale 0.6 TICK; set xlabel L('EAST_KM') offset 0,0.3
    plot for [k=1:SQUARES] TERRAIN using (km(column("x_m"))):(km(column("y_m"))):(PER_MAP[i]*column(NAMES[i])) with image pixels, \
         for [k=1:1 - SQUARES] TERRAIN using (km(column("x_m"))):(km(column("y_m"))):(PER_MAP[i]*column(NAMES[i])) every SIDE:SIDE with image, \
         TERRAIN using (i == 3 && strcol(NAMES[i]) eq 'nan' ? km(column("x_m")) : NaN):(km(column("y_m"))) with points pt 5 ps 2.2*EDGE*215/(8.0*(SPAN_X + 2*EDGE)) lc rgb '#ffffff'
    CLOW = GPVAL_CB_MIN; CHIGH = GPVAL_CB_MAX
    set cbrange [CLOW:CHIGH]; set xrange [0:1]; set yrange [CLOW:CHIGH]
    set lmargin at screen (x0 + 221)/WIDTH; set rmargin at screen (x0 + 230)/WIDTH
    unset title; unset xtics; unset ytics; set xlabel ""; set ylabel ""; set y2range [CLOW:CHIGH]; set y2tics border nomirror out scale 0.6 step((CHIGH - CLOW)/2.5)
    set print $SCALE; print 'value'
    do for [k=0:15] { print CLOW + (k + 0.5)*(CHIGH - CLOW)/16 }
    set print
    plot $SCALE using (0.5):1:(0.5):((CHIGH - CLOW)/32):1 with boxxyerror lc palette fs solid noborder
    unset y2tics
}
set lmargin at screen 384.0/WIDTH; set rmargin at screen 618.0/WIDTH
set border 3; set grid lw 0.5 lt 1 lc rgb '#e3e3e3' dt 1
set title L('EACH_PLACE') offset 0,-0.6
set xtics border nomirror out scale 0.6 autofreq; set ytics border nomirror out scale 0.6 autofreq; set format xy '%g'
set xlabel L('TOPEX'); set ylabel L('WIND_LEVEL') offset 1,0
set xrange [TLOW-(TLOW == THIGH):THIGH+(TLOW == THIGH)]; set yrange [FLOW-0.1*(FLOW == FHIGH):FHIGH+0.1*(FLOW == FHIGH)]
EVERY = 1 + int(POINTS/150)
plot TERRAIN using (int(column(0)) % EVERY ? NaN : column("topex_deg")):(column("wind_factor")) with dots lt 1
unset multiplot
set output

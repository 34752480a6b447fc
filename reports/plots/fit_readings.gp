# SPDX-License-Identifier: GPL-3.0-or-later
# Readings against load: points measured, line predicted, band 95 % of the prediction.
#   gnuplot -c fit_readings.gp FOLDER [FILE [LANGUAGE]]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'fit_readings.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
GROUPS = int(number('GROUPS', 0))
READINGS = DIR.'/tables/readings.csv'
SHOWN = GROUPS > 8 ? 8 : GROUPS
ROWS = (SHOWN + 1)/2
WIDTH = 640.0; STEP = 210.0; HEIGHT = STEP*ROWS
SPAN = SHOWN == 1 ? 556.0 : 232.0
in(g) = column("group") == g
load HERE.'start.gp'
set multiplot
unset key
do for [g=1:SHOWN] {
    i = g - 1; x0 = (i%2) ? 396.0 : 72.0; y1 = HEIGHT - 28.0 - STEP*(i/2)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + SPAN)/WIDTH
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - 122)/HEIGHT
    set title short(text_of('GROUP', g), SPAN + 60) offset 0,-0.6
    set xlabel with_unit(L(text_of('LOAD', g)), text_of('LOAD_UNIT', g)); set ylabel with_unit(L(text_of('GROUP_KIND', g)), text_of('GROUP_UNIT', g)) offset 1,0
    PER_X = per(text_of('LOAD_UNIT', g)); PER_Y = per(text_of('GROUP_UNIT', g))
    FREE = text_of('LOAD', g) eq 'free sway'
    set xrange [*:*]; set yrange [*:*]; set xtics autofreq; set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05
    if (FREE) { set xrange [-0.5:1.5]; set xtics (L('MEASURED') 0, L('FITTED') 1); set xlabel " "; unset ylabel; set title short(text_of('GROUP', g), SPAN).' ['.unit_said(text_of('GROUP_UNIT', g)).']'; set format y "%g"; set offsets 0, 0, graph 0.3, graph 0.3 }
    plot READINGS using (pick(in(g) && !FREE, PER_X*column("load"))):(pick(in(g), PER_Y*(column("predicted")-column("band_95")))):(pick(in(g), PER_Y*(column("predicted")+column("band_95")))) with filledcurves fs solid 0.2 noborder lt 1, \
         '' using (pick(in(g), FREE ? 0 : PER_X*column("load"))):(pick(in(g), PER_Y*column("measured"))):(PER_Y*column("sigma")) with yerrorbars lt 2 lw 1 dt 1 pt 6 ps 0.6, \
         '' using (pick(in(g) && !FREE, PER_X*column("load"))):(pick(in(g), PER_Y*column("predicted"))) with lines lt 1, \
         '' using (pick(in(g) && FREE, 1)):(pick(in(g), PER_Y*column("predicted"))):(PER_Y*column("band_95")) with yerrorbars lt 1 lw 1.2 pt 4 ps 0.7
}
unset multiplot
set output

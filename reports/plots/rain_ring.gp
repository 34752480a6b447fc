# SPDX-License-Identifier: GPL-3.0-or-later
# The leaf's tip after the last drop has fallen, with the envelope of the damping that was set.
#   gnuplot -c rain_ring.gp FOLDER FILE LANGUAGE RUN
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_ring.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'; RUN = ARGC > 3 ? int(ARG4) : 1
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
SERIES = DIR.'/tables/series.csv'; FROM = number('QUIET', RUN); DURATION = number('DURATION', RUN)
FREQUENCY = number('FREQUENCY', RUN); RATIO = number('RATIO', RUN)
WIDTH = 640.0; HEIGHT = 240.0
after(y) = pick(column("run") == RUN && column("time_s") > FROM, y)
late(y) = pick(column("run") == RUN && column("time_s") > FROM + 0.6*(DURATION - FROM), y)
stats SERIES using (late(PER_MM*column("tip_up_mm"))) nooutput
MEAN = STATS_mean
stats SERIES using (after(abs(PER_MM*column("tip_up_mm") - MEAN))) nooutput
MOST = STATS_max
load HERE.'start.gp'
set lmargin at screen 78.0/WIDTH; set rmargin at screen 618.0/WIDTH
set xrange [FROM:DURATION]; set yrange [*:*]
set xlabel L('TIME'); set ylabel L('RAIN_Y4') offset 1,0
set key top right
set samples 400
plot SERIES using (column("time_s")):(after(PER_MM*column("tip_up_mm"))) with lines lt 1 title L('RAIN_UP'), \
     MEAN + MOST*exp(-2*pi*FREQUENCY*RATIO*(x - FROM)) with lines lt 2 lw 1 title L('RAIN_ENVELOPE'), \
     MEAN - MOST*exp(-2*pi*FREQUENCY*RATIO*(x - FROM)) with lines lt 2 lw 1
set output

# SPDX-License-Identifier: GPL-3.0-or-later
# Water, drops by state, load on petiole and branch, and motion of the first leaf's tip over time.
#   gnuplot -c rain_series.gp FOLDER FILE LANGUAGE RUN
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_series.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'; RUN = ARGC > 3 ? int(ARG4) : 1
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
SERIES = DIR.'/tables/series.csv'; DURATION = number('DURATION', RUN)
WIDTH = 640.0; TALL = 104.0; STEP = 124.0; HEIGHT = 5*STEP + 46.0
load HERE.'start.gp'
set multiplot
set xrange [0:DURATION]; set yrange [*:*]
set lmargin at screen 78.0/WIDTH; set rmargin at screen 440.0/WIDTH
set key at screen 446.0/WIDTH, graph 1 left top Left reverse samplen 2 spacing 1.1 font ',9.5'
of_run(y) = pick(column("run") == RUN, y)
set format x ""
do for [p=1:5] {
    y0 = 14.0 + (p - 1)*STEP
    set tmargin at screen 1 - y0/HEIGHT; set bmargin at screen 1 - (y0 + TALL)/HEIGHT
    if (p == 5) { set format x "%g"; set xlabel L('TIME') offset 0,0.4 }
    set ylabel L(sprintf('RAIN_Y%d', p)) offset (p == 4 ? 0 : 1),0 font ',10'; set ytics font ',9.5'
    if (p == 1) { plot SERIES using (column("time_s")):(of_run(column("held_mg"))) with lines lt 1 title L('RAIN_HELD'), '' using (column("time_s")):(of_run(column("film_mg"))) with lines lt 3 title L('RAIN_FILM'), '' using (column("time_s")):(of_run(column("fell_mg"))) with lines lt 2 title L('RAIN_FELL') }
    if (p == 2) { plot SERIES using (column("time_s")):(of_run(column("rest"))) with lines lt 1 title L('RAIN_rest'), '' using (column("time_s")):(of_run(column("run_drops"))) with lines lt 2 title L('RAIN_run'), '' using (column("time_s")):(of_run(column("hang"))) with lines lt 4 title L('RAIN_hang') }
    if (p == 3) { plot SERIES using (column("time_s")):(of_run(column("petiole_moment_mNm"))) with lines lt 1 title L('RAIN_PETIOLE'), '' using (column("time_s")):(of_run(column("branch_moment_mNm"))) with lines lt 2 title L('RAIN_BRANCH') }
    if (p == 4) { plot SERIES using (column("time_s")):(of_run(PER_MM*column("tip_up_mm"))) with lines lt 1 lw 1.1 title L('RAIN_UP'), '' using (column("time_s")):(of_run(PER_MM*column("tip_across_mm"))) with lines lt 3 lw 1.1 title L('RAIN_SIDE'), '' using (column("time_s")):(of_run(PER_MM*column("branch_up_mm"))) with lines lt 2 lw 1.1 title L('RAIN_BRANCH_UP') }
    if (p == 5) { plot SERIES using (column("time_s")):(of_run(column("twist_deg"))) with lines lt 1 lw 1.1 title L('RAIN_TWIST') }
}
unset multiplot
set output

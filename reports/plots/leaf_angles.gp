# How one leaf turns on its stalk in time, run by run: in proportion to the wind (eq13), or by three noises.
#   gnuplot -c leaf_angles.gp FOLDER [FILE]
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'leaf_angles.svg'
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
ANGLES = DIR.'/tables/leaf_angles.csv'
SHOWS = ""
do for [r=1:RUNS] { if (FRAMES[r] > 1 && LEAVES[r] > 0 && words(SHOWS) < 6) { SHOWS = SHOWS.r." " } }
PANELS = words(SHOWS)
WIDTH = 640.0; ROW = 96.0; KEY = 30.0; HEIGHT = PANELS*(ROW + 26) + 40 + KEY
COLUMN = "swing_deg twist_deg theta_x_deg theta_y_deg theta_z_deg"
@start
set multiplot
set lmargin at screen 70.0/WIDTH; set rmargin at screen 625.0/WIDTH
set ytics 30 font ",8"; set xtics font ",9"
do for [p=1:PANELS] {
    r = nth(SHOWS, p); y1 = HEIGHT - 20 - (p - 1)*(ROW + 26)
    set tmargin at screen y1/HEIGHT; set bmargin at screen (y1 - ROW)/HEIGHT
    set title NAME[r] font ",9" offset 0,-0.9
    set ylabel "degrees" font ",9"
    if (p == PANELS) { set xlabel "time (s)" }
    set xrange [0:FRAMES[r]*STEP[r]]
    plot for [c=1:5] ANGLES using (pick(column("run") == r && column("leaf") == 1, column("time_s"))):(column(word(COLUMN, c))) with lines lt c lw 1.2
}
@strip
set key maxcols 5
plot for [c=1:5] -1 with lines lt c title word("swing twist theta-x theta-y theta-z", c)
unset multiplot
set output

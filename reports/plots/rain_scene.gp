# SPDX-License-Identifier: GPL-3.0-or-later
# The branch with its leaves in the key frames of a run, from the side, with the drops in the air as thin frustums. Leaves and branch move little:
# behind each frame the last one stands in grey, and the way from it is drawn enlarged, by a round factor that the picture states.
#   gnuplot -c rain_scene.gp FOLDER FILE LANGUAGE RUN
DIR = ARG1; OUT = ARGC > 1 ? ARG2 : 'rain_scene.svg'
LANGUAGE = ARGC > 2 ? ARG3 : 'en'; RUN = ARGC > 3 ? int(ARG4) : 1
HERE = ARG0; while (strlen(HERE) && HERE[strlen(HERE):] ne '/') { HERE = HERE[1:strlen(HERE)-1] }
load HERE.'style.gp'
KEYS = int(number('KEYS', RUN))
SCENE = DIR.'/tables/scene.csv'; AIR = DIR.'/tables/air.csv'
LOW_X = PER_M*number('LOW_X', RUN); HIGH_X = PER_M*number('HIGH_X', RUN); LOW_Z = PER_M*number('LOW_Z', RUN); HIGH_Z = PER_M*number('HIGH_Z', RUN)
SPAN_X = HIGH_X - LOW_X; BOTTOM = LOW_Z - 0.06*PER_M; TOP = HIGH_Z + 0.12*PER_M
WIDTH = 640.0; ACROSS = KEYS > 4 ? 4 : 3; DOWN = ceil(KEYS/(1.0*ACROSS))
# true to scale: an upright branch has room beside it
PANEL = (WIDTH - 64.0)/ACROSS - 12; WIDE = 1.06*SPAN_X; WIDE = WIDE*260 < PANEL*(TOP - BOTTOM) ? PANEL*(TOP - BOTTOM)/260 : WIDE
MIDDLE = 0.5*(LOW_X + HIGH_X); TALL = PANEL*(TOP - BOTTOM)/WIDE
KEY = 24.0; HEIGHT = DOWN*(TALL + 46.0) + 26.0 + KEY
# the rows of every frame are those of the last one, in the same order
array START[KEYS]; do for [k=1:KEYS] { START[k] = -1 }
begin(k, row) = k >= 1 && k <= KEYS && START[k] < 0 ? (START[k] = row) : 0
stats SCENE using (column("run") == RUN ? begin(int(column("key")), column(0)) : 0) name 'S' nooutput
stats SCENE using (pick(column("run") == RUN && column("key") == KEYS, 0)) name 'S' nooutput
array X0[S_records]; array Z0[S_records]; array X1[S_records]; array Z1[S_records]
index(k) = 1 + int(column(0) - START[k])
keep(i) = (X0[i] = PER_M*column("x0_m"), Z0[i] = PER_M*column("z0_m"), X1[i] = PER_M*column("x1_m"), Z1[i] = PER_M*column("z1_m"), 0)
stats SCENE using (column("run") == RUN && column("key") == KEYS ? keep(index(KEYS)) : 0) name 'S' nooutput
moved(k) = sqrt((PER_M*column("x1_m") - X1[index(k)])**2 + (PER_M*column("z1_m") - Z1[index(k)])**2)
stats SCENE using (column("run") == RUN ? moved(int(column("key"))) : 0) name 'S' nooutput
TIMES = 1.0
do for [t in "2 5 10 20 50"] { TIMES = real(t)*S_max <= 0.09*WIDE ? real(t) : TIMES }
grown(k, name, rest) = rest + TIMES*(PER_M*column(name) - rest)
ax(k) = grown(k, "x0_m", X0[index(k)]); az(k) = grown(k, "z0_m", Z0[index(k)])
bx(k) = grown(k, "x1_m", X1[index(k)]); bz(k) = grown(k, "z1_m", Z1[index(k)])
load HERE.'start.gp'
set multiplot
unset key; unset grid; set border 3 lw 0.5
set xrange [MIDDLE-0.5*WIDE:MIDDLE+0.5*WIDE]; set yrange [BOTTOM:TOP]
step = 50.0
do for [t in "20 10 5 2 1 0.5 0.2 0.1 0.05"] { step = real(t)*PANEL/WIDE >= 38 ? real(t) : step }
rise = step
do for [t in "20 10 5 2 1 0.5 0.2 0.1 0.05"] { rise = real(t)*TALL/(TOP - BOTTOM) >= 17 ? real(t) : rise }
set xtics step font ',9.5'; set ytics rise font ',9.5'; set format x "%.4g"
event(k) = L('RAIN_'.text_of(sprintf('EVENT_%d', RUN), k))
here(k) = column("run") == RUN && column("key") == k
at_frame(k, what) = here(k) && strcol("kind") eq what
do for [k=1:KEYS] {
    i = (k - 1) % ACROSS; j = (k - 1)/ACROSS
    x0 = 58.0 + i*(PANEL + 12.0); y0 = 22.0 + j*(TALL + 46.0)
    set lmargin at screen x0/WIDTH; set rmargin at screen (x0 + PANEL)/WIDTH
    set tmargin at screen 1 - y0/HEIGHT; set bmargin at screen 1 - (y0 + TALL)/HEIGHT
    set title sprintf('%s, %.3f s', event(k), number(sprintf('TIME_%d', RUN), k)) offset 0,-0.7 font ',9.5'
    if (i == 0) { set format y "%.4g" } else { set format y "" }
    if (j == DOWN - 1) { set xlabel L('RAIN_X') offset 0,0.6 } else { set xlabel "" }
    if (i == 0) { set ylabel L('RAIN_Z') offset -0.5,0 font ',9.5' } else { set ylabel "" }
    plot SCENE using (pick(here(KEYS), PER_M*column("x0_m"))):(PER_M*column("z0_m")):(PER_M*(column("x1_m")-column("x0_m"))):(PER_M*(column("z1_m")-column("z0_m"))) with vectors nohead lc rgb '#c8c8c8' dt 1 lw 0.8, \
         SCENE using (at_frame(k, "edge") ? ax(k) : NaN):(at_frame(k, "edge") ? az(k) : NaN):(at_frame(k, "edge") ? bx(k) - ax(k) : NaN):(at_frame(k, "edge") ? bz(k) - az(k) : NaN) with vectors nohead lt 3 dt 1 lw 0.9, \
         SCENE using (at_frame(k, "vein") ? ax(k) : NaN):(at_frame(k, "vein") ? az(k) : NaN):(at_frame(k, "vein") ? bx(k) - ax(k) : NaN):(at_frame(k, "vein") ? bz(k) - az(k) : NaN) with vectors nohead lc rgb '#7fcfb8' dt 1 lw 0.7, \
         SCENE using (at_frame(k, "petiole") ? ax(k) : NaN):(at_frame(k, "petiole") ? az(k) : NaN):(at_frame(k, "petiole") ? bx(k) - ax(k) : NaN):(at_frame(k, "petiole") ? bz(k) - az(k) : NaN) with vectors nohead lc rgb '#7a5a2f' dt 1 lw 1.2, \
         SCENE using (at_frame(k, "branch") ? ax(k) : NaN):(at_frame(k, "branch") ? az(k) : NaN):(at_frame(k, "branch") ? bx(k) - ax(k) : NaN):(at_frame(k, "branch") ? bz(k) - az(k) : NaN) with vectors nohead lc rgb '#5b3d16' dt 1 lw 2.2, \
         AIR using (pick(here(k), PER_M*column("x_m"))):(PER_M*column("z_m")):(-0.004*PER_M*column("vx_m_s")):(-0.004*PER_M*column("vz_m_s")) with vectors nohead lt 1 dt 1 lw 1.0
}
load HERE.'strip.gp'
plot 2 with lines, keyentry with lines lw 1.4 dt 1 lc rgb '#c8c8c8' title sprintf(L('RAIN_LAST'), sprintf('%g', TIMES))
unset multiplot
set output

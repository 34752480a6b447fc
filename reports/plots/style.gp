# SPDX-License-Identifier: GPL-3.0-or-later
# House style, loaded by every figure script. A script is called as
#   gnuplot -c SCRIPT FOLDER [FILE [LANGUAGE [RUN]]]
# FOLDER: a results folder of windfirm (tables/, plots/run.csv), of which only data are read. FILE: *.pdf and *.png are
# drawn as such, anything else as SVG. LANGUAGE: en or zh. RUN: which of several runs. Colours: Okabe & Ito 2008, safe for the colour-blind; lines also differ in dash and
# marker, so a copy in black and white can be read.
set encoding utf8
LANGUAGE = LANGUAGE eq 'zh' ? 'zh' : 'en'
if (!exists("FACTS")) { FACTS = 'run' }
load HERE.'facts.gp'
SUMMARY = DIR.'/tables/summary.csv'
SEGMENTS = DIR.'/tables/segments.csv'
SHAPE = DIR.'/tables/shape.csv'
SWEEP = DIR.'/tables/sweep.csv'

set linetype 1 lc rgb '#0072B2' lw 1.6 dt 1          pt 7  ps 0.7
set linetype 2 lc rgb '#D55E00' lw 1.6 dt (14,5)     pt 5  ps 0.6
set linetype 3 lc rgb '#009E73' lw 1.6 dt (4,3)      pt 9  ps 0.75
set linetype 4 lc rgb '#CC79A7' lw 1.6 dt (14,4,3,4) pt 13 ps 0.8
set linetype 5 lc rgb '#E69F00' lw 2.4 dt 1          pt 11 ps 0.75
set linetype 6 lc rgb '#56B4E9' lw 1.6 dt (8,3,2,3,2,3) pt 4 ps 0.65
set linetype cycle 6
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6 textcolor rgb '#202020'
set grid lw 0.5 lt 1 lc rgb '#e3e3e3' dt 1
set key top left Left reverse samplen 4 spacing 1.2 noautotitle
set minussign
set decimalsign '.'

ends(name, tail) = strlen(name) >= strlen(tail) && name[strlen(name)-strlen(tail)+1:] eq tail

# Rows of a table that belong to tree i at wind speed u; the value y elsewhere is not a number.
of(i) = column("tree") == i
at(i, u) = of(i) && abs(column("wind_m_s") - u) <= 1e-9*(1 + u)
pick(is, y) = is ? y : NaN
# A text of a user's, cut with an ellipsis to a place of so many pixels; Chinese characters are taken as wide.
short(text, pixels) = (SHORT_N = int(pixels/(LANGUAGE eq 'zh' ? 12.0 : 7.0)), SHORT_N = SHORT_N < 4 ? 4 : SHORT_N, \
    strlen(text) > SHORT_N ? text[1:SHORT_N - 1].'…' : text)
# The n-th number of a list; gnuplot evaluates a loop's body once even where the list is empty.
nth(list, n) = words(list) < n ? 1 : int(word(list, n))

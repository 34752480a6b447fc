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
# A text of a user's in so many pixels: in one line, shortened behind a word, or in two. Chinese characters are taken as wide.
ASCII = " !#$%&()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[]^_abcdefghijklmnopqrstuvwxyz{|}~'"
glyph(c) = strstrt(ASCII, c) ? 7 : 12
text_width(text) = sum [STYLE_I=1:strlen(text)] glyph(text[STYLE_I:STYLE_I])
# how many characters have room, then the last of them behind which a line may end
text_room(text, pixels) = (STYLE_W = 0, sum [STYLE_I=1:strlen(text)] (STYLE_W = STYLE_W + glyph(text[STYLE_I:STYLE_I]), STYLE_W <= pixels ? 1 : 0))
end_of_word(text, n) = (STYLE_E = n, (sum [STYLE_I=1:n] (STYLE_E = strstrt(" :，：、；", text[STYLE_I:STYLE_I]) && 3*STYLE_I > n ? STYLE_I : STYLE_E, 0)), STYLE_E)
trimmed(s) = strlen(s) && strstrt(" ,，：、；", s[strlen(s):]) ? s[1:strlen(s) - 1] : s
short(text, pixels) = text_width(text) <= pixels ? text : (STYLE_N = text_room(text, pixels - 12), STYLE_N = STYLE_N < 3 ? 3 : STYLE_N, \
    STYLE_S = trimmed(text[1:end_of_word(text, STYLE_N)]), trimmed(STYLE_S).'…')
two_lines(text, pixels) = text_width(text) <= pixels ? text : (STYLE_L = end_of_word(text, text_room(text, pixels)), \
    STYLE_F = trimmed(text[1:STYLE_L]), STYLE_F."\n".short(text[STYLE_L + 1:], pixels))
# The n-th number of a list; gnuplot evaluates a loop's body once even where the list is empty.
nth(list, n) = words(list) < n ? 1 : int(word(list, n))

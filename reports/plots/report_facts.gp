# SPDX-License-Identifier: GPL-3.0-or-later
# Loaded by the figures of a report: its trees and wind speeds.
trees = int(number('trees', 0))
array NAME[trees]; array HEIGHT_M[trees]; array AZIMUTH[trees]; array ROWS[trees]; array CRITICAL[trees]; array SOLVED[trees]; array LOSS_KNOWN[trees]
do for [i=1:trees] {
    NAME[i] = text_of('NAME', i); HEIGHT_M[i] = number('HEIGHT_M', i); AZIMUTH[i] = number('AZIMUTH', i)
    ROWS[i] = int(number('ROWS', i)); CRITICAL[i] = number('CRITICAL', i); SOLVED[i] = text_of('SOLVED', i)
    LOSS_KNOWN[i] = number('LOSS_KNOWN', i) == 1
}
winds = int(number('winds', 0))
array WIND[winds]
do for [i=1:winds] { WIND[i] = number('WIND', i) }
# The key has fewer columns when the names are long.
KEY_COLUMNS = 3
do for [i=1:trees] {
    do for [k=1:2] { if (KEY_COLUMNS > 1 && short(NAME[i], 500/KEY_COLUMNS - 20) ne NAME[i]) { KEY_COLUMNS = KEY_COLUMNS - 1 } }
}
KEY_ROWS = (trees + KEY_COLUMNS - 1)/KEY_COLUMNS
key_name(i) = short(NAME[i], 500/KEY_COLUMNS - 20)
STRONG = text_of('STRONG', 0)
SPEED_MAX = number('SPEED_MAX', 0)
# Units of the page, by the kind of a quantity: what data are multiplied with, and how it is called; without the facts metric.
SPEED = 1; LENGTH = 2; MOMENT = 3; STRESS = 4; FORCE = 5
array METRIC[5] = ['m/s', 'm', 'kN m', 'MPa', 'kN']
array UNIT[5]; array PER[5]
do for [i=1:5] { UNIT[i] = unit(METRIC[i]); PER[i] = per(METRIC[i]) }
put(s, a, b) = strstrt(s, a) ? s[1:strstrt(s, a) - 1].b.s[strstrt(s, a) + strlen(a):] : s
in_units(s) = put(s, '%s m/s', '%s '.UNIT[SPEED])
turned = PER[SPEED] != 1
said(k, x) = turned ? sprintf(PER[k]*x >= 1000 ? '%.0f' : '%.3g', PER[k]*x) : sprintf('%g', x)
# as typed; what was converted, with three figures
speed(u) = (turned || abs(10*u - floor(10*u + 0.5)) < 1e-6 ? said(SPEED, u) : sprintf('%.3g', u)).' '.UNIT[SPEED]
# Axes of lengths are drawn in metres: where a tic stands that the page's unit calls x, and its label.
lengths(x) = x/PER[LENGTH]
tic(x) = put(sprintf('%g', x), '-', '−')

# A plot that looks at some rows of a table alone (every ::first::last) reads the others without converting them. The rows of
# tree i at its n-th wind speed with an answer are row_first(i, n) to row_last(i, n), when rows.gp was loaded
# with TABLE set.
greater(a, b) = a > b ? a : b
place(i, k) = (i - 1)*winds + k
array FIRST[trees*winds + 1]; array LAST[trees*winds + 1]
find_place(i, u) = i < 1 || i > trees ? 0 : (sum [FACTS_J=1:winds] (abs(WIND[FACTS_J] - u) <= 1e-9*(1 + u) ? place(i, FACTS_J) : 0))
keep_row(p, row) = p < 1 || p > trees*winds ? 0 : (LAST[p] = row, FIRST[p] = FIRST[p] < 0 ? row : FIRST[p])
find_row(i, u, row) = (i == TREE_NOW && u == WIND_NOW ? 0 : (TREE_NOW = i, WIND_NOW = u, PLACE_NOW = find_place(int(i), u)), \
    keep_row(PLACE_NOW, row))
row_first(i, n) = greater(FIRST[place(i, nth(SOLVED[i], n))], 0)
row_last(i, n) = LAST[place(i, nth(SOLVED[i], n))]

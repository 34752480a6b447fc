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
# as typed; what was converted, with three figures
speed(u) = (abs(10*u - floor(10*u + 0.5)) < 1e-6 ? sprintf('%g m/s', u) : sprintf('%.3g m/s', u))

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

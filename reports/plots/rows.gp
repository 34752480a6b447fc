# SPDX-License-Identifier: GPL-3.0-or-later
# Loaded after report_facts.gp: where the rows of each tree and wind speed are in TABLE.
TREE_NOW = NaN; WIND_NOW = NaN; PLACE_NOW = 0
do for [p=1:|FIRST|] { FIRST[p] = -1; LAST[p] = 0 }
stats TABLE using (find_row(column("tree"), column("wind_m_s"), int(column(0)))) name 'LOADED' nooutput

# SPDX-License-Identifier: GPL-3.0-or-later
# Loaded by the figures of runs in time; lengths in the unit of the page.
RUNS = int(number('RUNS', 0))
array NAME[RUNS]; array KEYS[RUNS]; array FRAMES[RUNS]; array HEIGHT_M[RUNS]; array LEFT[RUNS]; array RIGHT[RUNS]
array TOP[RUNS]; array LEAVES[RUNS]; array STEP[RUNS]; array MOTION[RUNS]
do for [r=1:RUNS] {
    NAME[r] = text_of('NAME', r); KEYS[r] = int(number('KEYS', r)); FRAMES[r] = int(number('FRAMES', r))
    HEIGHT_M[r] = PER_M*number('HEIGHT_M', r); LEFT[r] = PER_M*number('LEFT', r); RIGHT[r] = PER_M*number('RIGHT', r)
    TOP[r] = PER_M*number('TOP', r); LEAVES[r] = int(number('LEAVES', r)); STEP[r] = number('STEP', r)
    MOTION[r] = text_of('MOTION', r)
}

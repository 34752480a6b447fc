# SPDX-License-Identifier: GPL-3.0-or-later
# Several figures of a folder by one gnuplot.
#   gnuplot -c several.gp FOLDER LIST LANGUAGE
# LIST: for each figure its script, the file to draw and the number of the run, words that windfirm made up.
SEVERAL = ARG0; while (strlen(SEVERAL) && SEVERAL[strlen(SEVERAL):] ne '/') { SEVERAL = SEVERAL[1:strlen(SEVERAL)-1] }
SEVERAL_IN = ARG1; SEVERAL_LIST = ARG2; SEVERAL_LANGUAGE = ARG3
do for [SEVERAL_AT=1:words(SEVERAL_LIST):3] {
    call SEVERAL.word(SEVERAL_LIST, SEVERAL_AT).'.gp' SEVERAL_IN word(SEVERAL_LIST, SEVERAL_AT + 1) SEVERAL_LANGUAGE word(SEVERAL_LIST, SEVERAL_AT + 2)
    reset
    undefine FACTS
}

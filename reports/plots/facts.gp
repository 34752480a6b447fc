# SPDX-License-Identifier: GPL-3.0-or-later
# Loaded by style.gp: what windfirm says about a run, from FOLDER/plots/FILE.csv for every FILE of the list FACTS, and the
# labels from words.tsv. Both are read as data by column functions; nothing in them is run.
set datafile separator comma
set datafile columnheaders
FACTS_N = 0
do for [FACTS_FILE in FACTS] {
    stats DIR.'/plots/'.FACTS_FILE.'.csv' using (1) name 'LOADED' nooutput
    FACTS_N = FACTS_N + LOADED_records
}
array FACT_KEY[FACTS_N]
array FACT[FACTS_N]
FACTS_N = 0
keep_fact(k, v) = (FACTS_N = FACTS_N + 1, FACT_KEY[FACTS_N] = k, FACT[FACTS_N] = v, 1)
do for [FACTS_FILE in FACTS] {
    stats DIR.'/plots/'.FACTS_FILE.'.csv' using (keep_fact(strcol("key").' '.strcol("index"), strcol("value"))) name 'LOADED' nooutput
}
fact_row(k) = sum [FACTS_J=1:|FACT_KEY|] (FACT_KEY[FACTS_J] eq k ? FACTS_J : 0)
# A fact by key and index (0 for a single one): number() is NaN and text_of() is empty where there is none.
number(key, i) = (FACTS_R = fact_row(sprintf('%s %d', key, i)), FACTS_R > 0 ? real(FACT[FACTS_R]) : NaN)
text_of(key, i) = (FACTS_R = fact_row(sprintf('%s %d', key, i)), FACTS_R > 0 ? FACT[FACTS_R] : '')

set datafile separator tab
stats HERE.'words.tsv' using (1) name 'LOADED' nooutput
array WORD_KEY[LOADED_records]
array WORD[LOADED_records]
FACTS_N = 0
keep_word(k, t) = (FACTS_N = FACTS_N + 1, WORD_KEY[FACTS_N] = k, WORD[FACTS_N] = t, 1)
stats HERE.'words.tsv' using (keep_word(strcol("key"), strcol(LANGUAGE))) name 'LOADED' nooutput
set datafile separator comma
# A label; a word that has none stands for itself.
L(k) = (FACTS_R = (sum [FACTS_J=1:|WORD_KEY|] (WORD_KEY[FACTS_J] eq k ? FACTS_J : 0)), FACTS_R > 0 ? WORD[FACTS_R] : k)
# "name (unit)", or the name alone
with_unit(name, unit) = strlen(unit) ? name.' ['.unit_said(unit).']' : name
# a unit as it is written, of one as it is typed
unit_said(unit) = unit eq 'um/m' ? 'µm/m' : unit eq 'deg' ? '°' : unit

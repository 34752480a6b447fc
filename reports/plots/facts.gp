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
text_of(key, i) = (FACTS_R = fact_row(sprintf('SAID.%s %d', key, i)), FACTS_R = FACTS_R > 0 ? FACTS_R : fact_row(sprintf('%s %d', key, i)), \
    FACTS_R > 0 ? FACT[FACTS_R] : '')
# SAID.key: what the language of the page calls it. Units of the page: how a metric one is called, and what its numbers are multiplied with.
unit(name) = (FACTS_R = fact_row('UNIT.'.name.' 0'), FACTS_R > 0 ? FACT[FACTS_R] : name)
per(name) = (FACTS_R = fact_row('FACTOR.'.name.' 0'), FACTS_R > 0 ? real(FACT[FACTS_R]) : 1.0)
PER_M = per('m'); PER_MM = per('mm'); PER_KM = per('km'); PER_MS = per('m/s')
# a quantity in words, as typed (in another unit to the same part of itself, as in the page's text) or with three figures
places(x, name) = (x == int(x) ? 0 : 1) - floor(log10(per(name)) + 0.3)
decimals(n) = n > 0 ? sprintf('%%.%df', n) : '%.0f'
typed(x, name) = (per(name) == 1 ? sprintf('%g', x) : sprintf(decimals(places(x, name)), per(name)*x)).' '.unit(name)
three(x, name) = sprintf('%.3g', per(name)*x).' '.unit(name)

set datafile separator tab
stats HERE.'words.tsv' using (1) name 'LOADED' nooutput
array WORD_KEY[LOADED_records]
array WORD[LOADED_records]
FACTS_N = 0
keep_word(k, t) = (FACTS_N = FACTS_N + 1, WORD_KEY[FACTS_N] = k, WORD[FACTS_N] = t, 1)
stats HERE.'words.tsv' using (keep_word(strcol("key"), strcol(LANGUAGE))) name 'LOADED' nooutput
set datafile separator comma
# A label, its unit in brackets that of the page; a word that has none stands for itself.
word_of(k) = (FACTS_R = (sum [FACTS_J=1:|WORD_KEY|] (WORD_KEY[FACTS_J] eq k ? FACTS_J : 0)), FACTS_R > 0 ? WORD[FACTS_R] : k)
bracket(s) = (FACTS_A = strstrt(s, '['), FACTS_B = strstrt(s, ']'), FACTS_A && FACTS_B > FACTS_A + 1 ? s[1:FACTS_A].unit(s[FACTS_A + 1:FACTS_B - 1]).s[FACTS_B:] : s)
L(k) = bracket(word_of(k))
# "name [unit]", or the name alone
with_unit(name, of) = strlen(of) ? name.' ['.unit_said(of).']' : name
# a unit as it is written, of one as it is typed
unit_said(name) = name eq 'um/m' ? 'µm/m' : name eq 'deg' ? '°' : unit(name)

# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of windfirm's command lines in bash. The words come from the program itself (--help=words), so that they are
# those of the version that is installed.

# Lines that begin with what is typed, as COMPREPLY; a line is one word.
_windfirm_offer() {
    local line
    COMPREPLY=()
    while IFS= read -r line; do
        [[ -n $line && $line == "$1"* ]] && COMPREPLY+=("$line")
    done
}

# Names of a kind: command, species, models.
_windfirm_names() { "${COMP_WORDS[0]}" --help=words 2>/dev/null | awk -F'\t' -v kind="$1" '$2 == kind { print $1 }'; }

_windfirm() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words name kind allowed
    if [[ $COMP_CWORD -eq 1 ]]; then
        _windfirm_offer "$word" < <(_windfirm_names command)
        return
    fi
    words=$("${COMP_WORDS[0]}" "${COMP_WORDS[1]}" --help=words 2>/dev/null)
    while IFS=$'\t' read -r name kind allowed; do
        [[ $name == "$before" && $kind != none ]] || continue
        if [[ $kind == word ]]; then
            _windfirm_offer "$word" < <(tr ' ' '\n' <<<"$allowed")
        else
            compopt -o filenames 2>/dev/null
            _windfirm_offer "$word" < <(compgen -f -- "$word"; [[ $name != --model ]] || _windfirm_names models)
        fi
        return
    done <<<"$words"
    if [[ $word == -* ]]; then
        _windfirm_offer "$word" < <(cut -f1 <<<"$words")
    else
        compopt -o filenames 2>/dev/null
        _windfirm_offer "$word" < <(compgen -f -- "$word"; _windfirm_names species)
    fi
}
complete -F _windfirm windfirm

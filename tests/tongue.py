# SPDX-License-Identifier: GPL-3.0-or-later
"""Is the catalogue of translations complete, and is English left in Chinese pages?

tongue.py formats            every warning's format in src, and every placeholder of a translation
tongue.py notes              every clause of the notes of species tables, and names and notes of tree models
tongue.py terminal            every format that the commands which compute print
tongue.py said                English sentences in what a command printed, on the standard input
tongue.py pages PAGE.html... words of Latin letters in Chinese pages that are no names, citations, units, keys or files
Prints what is missing, and a last line with the number of texts that were looked at. Exit code 1 where something is missing."""
import glob
import html
import re
import sys
import xml.etree.ElementTree as tree

CATALOGUE = {m.find('en').text: m.find('zh').text for m in tree.parse('reports/messages.xml').getroot().iter('m')}
NUMBER = re.compile(r'(?<![A-Za-z0-9^_.])\d+(?:\.\d+)?(?![A-Za-z0-9]|\.\d*[A-Za-z])')
CONVERSION = re.compile(r'%%|%[-+ #0]*(?:\*|\d+)?(?:\.(?:\*|\d+))?(?:hh|h|ll|l|z|j|t|L)?[a-zA-Z]')


def numbered(pattern, text):
    count = [0]

    def number(found):
        if found.group(0) == '%%':
            return '%'
        count[0] += 1
        return '{%d}' % count[0]
    return pattern.sub(number, text)


def literal(source, at):
    """The string literal, of one or more pieces, that begins at `at`; None where there is none."""
    pieces = re.match(r'(?:\s*"(?:[^"\\]|\\.)*")+', source[at:])
    return None if not pieces else ''.join(re.findall(r'"((?:[^"\\]|\\.)*)"', pieces.group(0))).encode().decode('unicode_escape')


def formats():
    found = []
    for name in glob.glob('src/*/*.c'):
        source = open(name, encoding='utf-8').read()
        for call in re.finditer(r'\bwf_diag_warn\(\s*[^,]+,\s*[^,]+,', source):
            text = literal(source, call.end())
            if text and text != '%s' and '%s: %s%s%s' not in text:
                found.append(numbered(CONVERSION, text))
    return found


def printed():
    """Formats of wf_show with words in them; what comes before it or behind is no part of a text of the catalogue."""
    found = []
    for name in glob.glob('src/cmd/analyze_*.c') + glob.glob('src/cmd/print_*.c') + glob.glob('src/cmd/assess_*.c') + [
            'src/cmd/cmd_%s.c' % c for c in ('analyze', 'assess', 'explain', 'extremes', 'fit', 'fragility', 'import', 'modes', 'rain', 'series', 'species',
                                             'shelter', 'terrain', 'wind')]:
        source = open(name, encoding='utf-8').read()
        for call in re.finditer(r'\bwf_show\(\s*[^,]+,', source):
            text = literal(source, call.end())
            plain = numbered(CONVERSION, text) if text else ''
            if re.search('[A-Za-z]{2}', re.sub(r'\{\d+\}', '', plain)):
                found.append(plain if plain in CATALOGUE else plain.strip(' \n'))
    return found


def clauses(text):
    text = ' '.join(text.split())
    for clause in [text] if text in CATALOGUE else text.split('; '):
        whole = re.sub(r'\.$', '', clause)
        if numbered(NUMBER, whole) in CATALOGUE or clause in CATALOGUE:
            yield numbered(NUMBER, whole) if clause not in CATALOGUE else clause
            continue
        for sentence in re.split(r'\. (?=[A-Z])', whole):
            yield from (numbered(NUMBER, part) for part in ([sentence] if numbered(NUMBER, sentence) in CATALOGUE else
                                                            sentence.split(': ')))


def notes():
    import yaml

    def of(value):
        if isinstance(value, dict):
            for key, inner in value.items():
                if key == 'note' and isinstance(inner, str):
                    yield inner
                else:
                    yield from of(inner)
        elif isinstance(value, list):
            for inner in value:
                yield from of(inner)
    found = []
    for name in glob.glob('species/*.yaml'):
        for note in of(yaml.safe_load(open(name, encoding='utf-8'))):
            found += [c for c in clauses(note) if not re.fullmatch(r'\W*\{1\}( to \{2\})?\W*', c)]
    for name in glob.glob('models/*.yaml'):
        model = yaml.safe_load(open(name, encoding='utf-8'))
        found += [' '.join(model[k].split()) for k in ('name', 'note') if model.get(k)]
    return found


# What may stand in Latin letters: a sentence of English has three small words in a row.
SENTENCE = re.compile(r"(?<![\w'-])[a-z]{2,}(?:['’]s)?(?:,? +[a-z]{2,}){2,}(?![\w-])")


def pages(names):
    found, missing = 0, []
    for name in names:
        page = open(name, encoding='utf-8').read()
        page = re.sub(r'<(style|script)\b.*?</\1>|<ol class="sources".*?</ol>|<(code|i)\b.*?</\2>', ' ', page, flags=re.S)
        for text in re.split(r'<[^>]+>', page):
            text = html.unescape(text).strip()
            found += bool(text)
            cited = re.sub(r'[A-Z][^；。]*?\b(?:19|20)\d\d\b[^；。]*', ' ', text)  # from a name on, a year in it
            said = SENTENCE.search(cited)
            if said:
                missing.append('%s: %s' % (name, said.group(0)))
    return found, missing


def main():
    kind = sys.argv[1]
    if kind == 'said':
        lines = [re.sub(r'\([A-Z][^()]*\)', ' ', line) for line in sys.stdin]
        found, missing = len(lines), [line.strip() for line in lines if SENTENCE.search(line)]
    elif kind == 'pages':
        found, missing = pages(sys.argv[2:])
    else:
        texts = formats() if kind == 'formats' else printed() if kind == 'terminal' else notes()
        found, missing = len(texts), [t for t in texts if t not in CATALOGUE]
    if kind == 'formats':
        for english, own in CATALOGUE.items():
            wrong = set(re.findall(r'\{\d+\}', own)) - set(re.findall(r'\{\d+\}', english))
            missing += ['%s has no %s' % (english, ', '.join(wrong))] if wrong or not own else []
    for text in missing:
        print('missing: ' + text)
    print('tongue: %d looked at, %d missing' % (found, len(missing)))
    sys.exit(bool(missing))


main()

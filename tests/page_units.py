# SPDX-License-Identifier: GPL-3.0-or-later
# Pages of the same run in metric, imperial and Chinese units: each number of the metric page that another shows in another
# unit is compared with it, and words that name no number are the same.
#   python3 page_units.py METRIC IMPERIAL CN      (results folders)
import html, json, re, sys

FACTOR = {('m/s', 'mph'): 1 / 0.44704, ('m', 'ft'): 1 / 0.3048, ('cm', 'in'): 1 / 2.54, ('mm', 'in'): 1 / 25.4,
          ('m²', 'ft²'): 1 / 0.3048 ** 2, ('kN m', 'kip·ft'): 1 / 1.3558179483314, ('MPa', 'psi'): 145.037737730209,
          ('GPa', 'ksi'): 145.037737730209, ('kg', 'lb'): 1 / 0.45359237, ('kg/m³', 'lb/ft³'): 0.3048 ** 3 / 0.45359237,
          ('kg/m²', 'lb/ft²'): 0.3048 ** 2 / 0.45359237, ('kN m/m3', 'kip/ft2'): 0.020885434233150, ('kN m', 'kN·m'): 1, ('GPa', 'MPa'): 1000, ('mm', 'cm'): 0.1}
MARKS = re.compile('[\ue000-\ue0ff]')


def cells(folder):
    page = open(folder + '/report.html', encoding='utf-8').read()
    if MARKS.search(page):
        sys.exit(folder + ': marks are left')
    page = re.sub(r'<(svg|style|script).*?</\1>', '', page, flags=re.S)
    page = re.sub(r'</?(b|i|em|sub|sup)( [^>]*)?>', '', page).replace('\u2060', '')
    out, heads = [], []
    for kind, text in re.findall(r'<(t[hdr]|p|caption|figcaption|h\d|li|thead|table)(?: [^>]*)?>([^<]*(?:<(?:span|br)[^>]*>[^<]*(?:</span>)?)*)', page):
        if kind == 'table':
            heads, row = [], -1
        if kind == 'tr':
            column = 0
        unit = re.search(r'<span class="u">(.*?)\xa0?</span>', text)
        text = html.unescape(re.sub('<[^>]*>', ' ', text))
        if kind == 'th':
            heads.append(unit.group(1).strip('\xa0 ') if unit else '')
        head = heads[column] if kind == 'td' and column < len(heads) else ''
        if kind in ('td', 'th'):
            column += 1
        out.append((kind, head, text))
    return out


NUMBER = re.compile(r'[−-]?\d[\d,]*(?:\.\d+)?')
value = lambda t: float(t.replace(',', '').replace('−', '-'))


def compare(metric, other, name):
    a, b = cells(metric), cells(other)
    if len(a) != len(b):
        sys.exit(f'{name}: {len(b)} places, not {len(a)}')
    turned = 0
    for (kind, head, text), (_, head2, text2) in zip(a, b):
        if re.search(r'\d\d:\d\d:\d\d', text):   # the runs were a second apart
            continue
        if text == text2:
            if FACTOR.get((head, head2), 1) != 1 and NUMBER.search(text) and value(NUMBER.search(text).group()) != 0:
                sys.exit(f'{name}: "{text}" is not turned under {head2}')
            continue
        n, m = NUMBER.findall(text), NUMBER.findall(text2)
        if len(n) != len(m):
            sys.exit(f'{name}: "{text2}" has not the numbers of "{text}"')
        for x, y in zip(n, m):
            if x == y:
                continue
            ratios = {FACTOR[(head, head2)]} if (head, head2) in FACTOR else set(FACTOR.values())
            half = 0.5 * 10 ** -len(x.partition('.')[2]) + 1e-9
            fits = [f for f in ratios if abs(value(y) - f * value(x)) <= 1.0 * half * f + 0.5 * 10 ** -len(y.partition('.')[2])
                    + 0.005 * abs(value(y))]
            if not fits:
                sys.exit(f'{name}: {x} became {y} in "{text2}" under {head} -> {head2}')
            turned += 1
    return turned


metric, imperial, cn = sys.argv[1:4]
n = compare(metric, imperial, 'imperial')
m = compare(metric, cn, 'cn')
results = json.load(open(imperial + '/results.json'))
lost = results['trees'][0]['verdict']['critical_speed']['value']
text = ' '.join(t for _, _, t in cells(imperial))
for want in (f'{lost / 0.44704:.1f} mph', '30 m/s and 5 m', '66 ft', 'kip·ft'):
    if want not in text:
        sys.exit(f'imperial: no "{want}"')
left = re.findall(r'\d (?:m/s|m|kN m|MPa|kg)(?![/·²³\w])', text.replace('30 m/s and 5 m', ''))
if left:
    sys.exit(f'imperial: left in metric units: {left}')
if json.dumps(results['trees'][0]['winds']) != json.dumps(json.load(open(metric + '/results.json'))['trees'][0]['winds']):
    sys.exit('results differ')
if n < 100 or m < 8:
    sys.exit(f'{n} and {m} numbers were turned')
print(f'units: {n} and {m} numbers')

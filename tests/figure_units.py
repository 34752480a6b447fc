# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a page in imperial units beside those of the metric page.

figure_units.py METRIC IMPERIAL same FIGURE...    the same lines, drawn to scale, with other numbers at the axes
figure_units.py METRIC IMPERIAL factor FIGURE...  the highest point of the first curve, read by the numbers at the y axis: what it is
                                                  multiplied with
figure_units.py IMPERIAL labels                   labels of all figures that still name a metric unit
Prints one line a figure."""
import glob
import re
import sys
import xml.etree.ElementTree as tree

SVG = '{http://www.w3.org/2000/svg}'
METRIC = re.compile(r'\[(?:m/s|m|cm|mm|km|kN|kN m|MPa|GPa|kN m/rad)\]|\d m(?:/s)?(?!\S)')


def shift(text):
    found = re.search(r'translate\(([-\d.]+),([-\d.]+)\)', text or '')
    return [float(found.group(1)), float(found.group(2))] if found else [0, 0]


def texts(picture):
    for group in picture.iter(SVG + 'g'):
        for t in group.findall(SVG + 'text'):
            yield shift(group.get('transform')), group.get('text-anchor', ''), ''.join(t.itertext()).strip()


def read(folder, name):
    return tree.parse('%s/plots/%s.svg' % (folder, name)).getroot()


def longest(picture):
    """The points of the three longest paths."""
    paths = sorted((p.get('d') for p in picture.iter(SVG + 'path') if p.get('d')), key=len)[-3:]
    return [[float(n) for n in re.findall(r'-?\d+(?:\.\d+)?', d)] for d in paths]


def alike(a, b):
    """Apart by a rounding of a tenth of a pixel."""
    return all(len(p) == len(q) and max(abs(x - y) for x, y in zip(p, q)) < 0.25 for p, q in zip(longest(a), longest(b)))


def highest(picture):
    """The highest point of the longest path, by the labels at the left."""
    marks = [(y, float(t.replace('−', '-'))) for (x, y), anchor, t in texts(picture)
             if anchor == 'end' and re.fullmatch(r'−?[\d.]+', t)]
    (y0, v0), (y1, v1) = min(marks), max(marks)
    path = max((p.get('d') for p in picture.iter(SVG + 'path') if p.get('d')), key=len)
    y = min(float(k) for k in re.findall(r'[-\d.]+,([-\d.]+)', path))
    return v0 + (y - y0) * (v1 - v0) / (y1 - y0)


def main():
    if sys.argv[2] == 'labels':
        for name in sorted(glob.glob(sys.argv[1] + '/plots/*.svg')):
            for _, _, t in texts(tree.parse(name).getroot()):
                if METRIC.search(t):
                    print('%s: %s' % (name.split('/')[-1], t))
        print('labels looked at')
        return
    for name in sys.argv[4:]:
        a, b = read(sys.argv[1], name), read(sys.argv[2], name)
        if sys.argv[3] == 'factor':
            print('%s: times %.3g' % (name, highest(b) / highest(a)))
            continue
        other = {t for _, _, t in texts(a)} != {t for _, _, t in texts(b)}
        print('%s: %s, %s' % (name, 'same lines' if alike(a, b) else 'other lines', 'other numbers' if other else 'same numbers'))


main()

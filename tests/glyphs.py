# SPDX-License-Identifier: GPL-3.0-or-later
# The fonts that reports/pdf.py cuts down, beside the fonts they are cut from: outlines and widths are the same, nothing else
# is there. Given: reports/pdf.py, and fonts. Prints the number of fonts that were compared.
import importlib.util
import io
import logging
import sys

from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont

sys.dont_write_bytecode = True
logging.disable()  # of the bytes that fill an outline up
spec = importlib.util.spec_from_file_location('pdf', sys.argv[1])
pdf = importlib.util.module_from_spec(spec)
spec.loader.exec_module(pdf)


def outline(font, name):
    glyphs = font.getGlyphSet()
    pen = DecomposingRecordingPen(glyphs)
    glyphs[name].draw(pen)
    return pen.value, glyphs[name].width


compared = 0
for path in sys.argv[2:]:
    with open(path, 'rb') as f:
        content = f.read()
    whole = TTFont(io.BytesIO(content), fontNumber=0)
    # text, letters composed of two glyphs, Chinese
    wanted = {whole.getGlyphID(whole.getBestCmap()[ord(c)]) for c in 'Wind 10 m/s \u00e4\u00e9\u00b0\u6811\u98ce'
              if ord(c) in whole.getBestCmap()}
    few = pdf.few_glyphs(content, 0, wanted)
    if few is None:
        sys.exit(path + ': was not cut down')
    # one and the same checksum of every font
    if pdf.sum_of(few) != 0xb1b0afba:
        sys.exit(path + ': checksum')
    small = TTFont(io.BytesIO(few), checkChecksums=2)
    for glyph in wanted:
        if outline(small, small.getGlyphName(glyph)) != outline(whole, whole.getGlyphName(glyph)):
            sys.exit('%s: glyph %d differs' % (path, glyph))
    full = sum(1 for name in small.getGlyphOrder() if small['glyf'][name].numberOfContours)
    if full > 2 * len(wanted) or len(few) > len(content) / 3:
        sys.exit('%s: %d glyphs of %d, %d bytes' % (path, full, len(wanted), len(few)))
    compared += 1
print(compared)

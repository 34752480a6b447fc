# SPDX-License-Identifier: GPL-3.0-or-later
# The bold Chinese face of printed pages: the characters of this program's own Chinese words, out of Noto Sans CJK SC Bold (Debian
# package fonts-noto-cjk; licence in reports/han_bold.txt), as TrueType outlines, which reports/pdf.py takes apart quickly; the whole
# face would take seconds a page.
#   python3 han_bold.py FILE.ttf NotoSansCJK-Bold.ttc WORDS...     needs fontTools, which WeasyPrint brings
import sys

from fontTools import subset
from fontTools.pens.cu2quPen import Cu2QuPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont, newTable

file, face, words = sys.argv[1], sys.argv[2], sys.argv[3:]
text = ''.join(open(name, encoding='utf-8').read() for name in words)
font = TTFont(face, fontNumber=2)  # of the collection: SC
options = subset.Options(layout_features=[], hinting=False, desubroutinize=True)
few = subset.Subsetter(options)
few.populate(unicodes=[ord(c) for c in {" ", "\u00a0", *text} if ord(c) > 0x2e7f or c in " \u00a0"])  # blanks between such characters
few.subset(font)
outlines, order, glyphs = font.getGlyphSet(), font.getGlyphOrder(), {}
for name in order:
    pen = TTGlyphPen(None)
    outlines[name].draw(Cu2QuPen(pen, 1.5, reverse_direction=True))
    glyphs[name] = pen.glyph()
font['loca'], font['glyf'] = newTable('loca'), newTable('glyf')
font['glyf'].glyphOrder, font['glyf'].glyphs = order, glyphs
most = font['maxp']
most.tableVersion, most.maxZones = 0x00010000, 1
for name in ('TwilightPoints', 'Storage', 'FunctionDefs', 'InstructionDefs', 'StackElements', 'SizeOfInstructions', 'ComponentElements'):
    setattr(most, 'max' + name, 0)
for tag in ('CFF ', 'VORG', 'GPOS', 'GSUB', 'GDEF', 'BASE', 'vhea', 'vmtx'):
    if tag in font:
        del font[tag]
# lines are as high as those of the face beside it
lines, os2 = font['hhea'], font['OS/2']
lines.ascent, lines.descent, lines.lineGap = 880, -120, 0
os2.usWinAscent, os2.usWinDescent, os2.sTypoAscender, os2.sTypoDescender, os2.sTypoLineGap = 880, 120, 880, -120, 0
font['post'].formatType, font.sfntVersion = 3.0, '\0\1\0\0'
font.save(file)
print(len(glyphs) - 1, 'characters')

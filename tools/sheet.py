# SPDX-License-Identifier: GPL-3.0-or-later
# Contact sheet of pictures: python3 sheet.py FILE.png PICTURE... ; seven a row. Needs Pillow, which WeasyPrint brings.
import sys
from PIL import Image

files, wide, row = sys.argv[2:], 300, 7
pages = [Image.open(f).convert('RGB') for f in files]
pages = [p.resize((wide, p.height * wide // p.width)) for p in pages]
high = max(p.height for p in pages) + 4
sheet = Image.new('RGB', (row * (wide + 4), -(-len(pages) // row) * high), '#888')
for i, p in enumerate(pages):
    sheet.paste(p, (i % row * (wide + 4) + 2, i // row * high + 2))
sheet.save(sys.argv[1])

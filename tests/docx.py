# SPDX-License-Identifier: GPL-3.0-or-later
# A page for a word processor, converted back by pandoc: it has the numbers of the page, in their order, and its figures.
#   python3 docx.py FOLDER PAGE
import re, subprocess, sys, zipfile

folder, page = sys.argv[1:3]
NUMBER = re.compile(r'\d+(?:,\d{3})*(?:\.\d+)?')
html = open(f'{folder}/{page}.html', encoding='utf-8').read()
figures = len(re.findall(r'<figure', html))
html = re.sub(r'<section id="live".*?</section>', '', html, flags=re.S)
html = re.sub(r'<(svg|style|script|title|head).*?</\1>', '', html, flags=re.S)
want = NUMBER.findall(re.sub(r'<[^>]*>', ' ', html))
back = subprocess.run(['pandoc', '-f', 'docx', '-t', 'html', '--wrap', 'none', f'{folder}/{page}.docx'],
                      capture_output=True, text=True, check=True).stdout
back = re.sub(r'<(colgroup|style).*?</\1>', '', back, flags=re.S)
# captions stand twice in pandoc's reading: as a caption and as a paragraph
found = NUMBER.findall(re.sub(r'<[^>]*>', ' ', back))
at = 0
for k, number in enumerate(want):
    try:
        at = found.index(number, at) + 1
    except ValueError:
        sys.exit(f'number {k}, {number}, behind {want[max(0, k - 8):k]} is not in the document in this order')
media = [n for n in zipfile.ZipFile(f'{folder}/{page}.docx').namelist() if n.startswith('word/media/')]
for n in media:
    if zipfile.ZipFile(f'{folder}/{page}.docx').read(n)[:8] != b'\x89PNG\r\n\x1a\n':
        sys.exit(f'{n}: no PNG')
if len(media) != figures:
    sys.exit(f'{len(media)} pictures of {figures} figures')
# columns are as wide as what stands in them, not all the same
document = zipfile.ZipFile(f'{folder}/{page}.docx').read('word/document.xml').decode()
grids = [re.findall(r'<w:gridCol w:w="(\d+)"', g) for g in re.findall(r'<w:tblGrid>.*?</w:tblGrid>', document, re.S)]
if not all(len(set(g)) > 1 for g in grids if len(g) > 3):
    sys.exit(f'columns of the same width: {grids}')
if len(want) < 50:
    sys.exit(f'{len(want)} numbers on the page')
print(f'docx: {len(want)} numbers, {len(media)} pictures')

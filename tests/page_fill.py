# SPDX-License-Identifier: GPL-3.0-or-later
"""How far down the words of each page of a PDF reach, labels of figures among them, in per cent between head and foot.

page_fill.py FILE.pdf...   one line a file: the least of the pages but the last, and the last (100 where there is one page)"""
import re
import subprocess
import sys

for name in sys.argv[1:]:
    shares = []
    text = subprocess.run(['pdftotext', '-bbox', name, '-'], capture_output=True, text=True, check=True).stdout
    for page in re.split(r'<page ', text)[1:]:
        height = float(re.search(r'height="([\d.]+)"', page).group(1))
        low, high = 0.05 * height, 0.94 * height
        ends = [float(y) for y in re.findall(r'yMax="([\d.]+)"', page)]
        shares.append(100 * (max([y for y in ends if low < y < high] or [low]) - low) / (high - low))
    print('%d %d' % (min(shares[:-1] or [100]), shares[-1]))

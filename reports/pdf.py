# SPDX-License-Identifier: GPL-3.0-or-later
# Pages to PDFs by WeasyPrint: python -E pdf.py. An order on the standard input is a folder, PAGE.html and FILE.pdf, each
# ended by a zero byte: FOLDER/PAGE.html is printed to FOLDER/FILE.pdf. The answer on the standard output is what WeasyPrint
# says, and a zero byte. A page that cannot be printed ends the process. The page carries its styles and pictures in itself;
# no other file and no address is fetched, whatever the page names.
import base64
import gc
import logging
import os
import sys
from array import array
from struct import pack, unpack_from

try:
    import weasyprint
except ImportError as why:
    print(why)
    sys.exit(127)  # as a shell says of a program that is not there


def fetch(url, *args, **options):
    if not url.startswith('data:'):
        raise ValueError('only data: addresses are read')
    return weasyprint.default_url_fetcher(url, *args, **options)


# A TrueType font with some of its glyphs, under their numbers, without hints. WeasyPrint 57 leaves that to fontTools, which
# takes half the time of a Chinese page, because it handles every one of 50000 glyphs as an object of Python.

NEEDED = b'glyf', b'head', b'hhea', b'hmtx', b'loca', b'maxp'
# outlines of another kind, or chosen by a variation
OTHER = b'CBDT', b'CFF ', b'CFF2', b'COLR', b'EBDT', b'SVG ', b'fvar', b'sbix'


def tables_of(font, index):
    start = unpack_from('>I', font, 12 + 4 * index)[0] if font[:4] == b'ttcf' else 0
    if font[start:start + 4] not in (b'\0\1\0\0', b'true'):
        return {}
    count = unpack_from('>H', font, start + 4)[0]
    rows = [unpack_from('>4sIII', font, start + 12 + 16 * i) for i in range(count)]
    return {tag: font[at:at + size] for tag, _, at, size in rows if tag in NEEDED or tag in OTHER}


def plain_glyph(outline):
    """The outline without hints, and the glyphs it is composed of."""
    contours = unpack_from('>h', outline)[0]
    if contours >= 0:
        at = 10 + 2 * contours
        hints = unpack_from('>H', outline, at)[0]
        return outline[:at] + b'\0\0' + outline[at + 2 + hints:], []
    parts, at, more, plain = [], 10, True, bytearray(outline)
    while more:
        flags, part = unpack_from('>HH', outline, at)
        parts.append(part)
        plain[at:at + 2] = pack('>H', flags & ~0x100)  # no hints follow
        at += 4 + (4 if flags & 1 else 2) + (2 if flags & 8 else 4 if flags & 0x40 else 8 if flags & 0x80 else 0)
        more = flags & 0x20
    return bytes(plain[:at]), parts


def sum_of(table):
    words = array('I', table + bytes(-len(table) % 4))
    if sys.byteorder == 'little':
        words.byteswap()
    return sum(words) & 0xffffffff


def few_glyphs(font, index, glyphs):
    """The font as bytes; None when it is of another kind."""
    table = tables_of(font, index)
    if any(tag in table for tag in OTHER) or any(tag not in table for tag in NEEDED) or array('I').itemsize != 4:
        return None
    wide = unpack_from('>h', table[b'head'], 50)[0]
    place = array('I' if wide else 'H', table[b'loca'])
    if sys.byteorder == 'little':
        place.byteswap()
    scale = 1 if wide else 2
    kept, waiting = {}, [0, *glyphs]
    while waiting:
        glyph = waiting.pop()
        if glyph in kept or glyph + 1 >= len(place):
            continue
        outline = table[b'glyf'][scale * place[glyph]:scale * place[glyph + 1]]
        kept[glyph], parts = plain_glyph(outline) if outline else (b'', [])
        waiting += parts
    count, long = max(kept) + 1, unpack_from('>H', table[b'hhea'], 34)[0]
    body, start, size = [], array('I'), 0
    for glyph in range(count):
        start.append(size)
        outline = kept.get(glyph)
        if outline:
            body.append(outline + bytes(-len(outline) % 4))
            size += len(body[-1])
    start.append(size)
    if sys.byteorder == 'little':
        start.byteswap()
    long = min(long, count)
    measures, end = bytearray(4 * long + 2 * (count - long)), 4 * (long - 1)
    for glyph in kept:
        at, n = (4 * glyph, 4) if glyph < long else (4 * long + 2 * (glyph - long), 2)
        measures[at:at + n] = table[b'hmtx'][at:at + n]
    measures[end:end + 4] = table[b'hmtx'][end:end + 4]  # its width holds for those behind
    head, hhea, maxp = table[b'head'], table[b'hhea'], table[b'maxp']
    return written({b'glyf': b''.join(body), b'head': head[:8] + bytes(4) + head[12:50] + b'\0\1' + head[52:],
                    b'hhea': hhea[:34] + pack('>H', long), b'hmtx': bytes(measures), b'loca': start.tobytes(),
                    b'maxp': maxp[:4] + pack('>H', count) + maxp[6:]})


def written(table):
    n = len(table)
    power = n.bit_length() - 1
    rows, body = [], b''
    for tag in sorted(table):
        rows.append(pack('>4sIII', tag, sum_of(table[tag]), 12 + 16 * n + len(body), len(table[tag])))
        body += table[tag] + bytes(-len(table[tag]) % 4)
        if tag == b'head':
            head = len(body) - len(table[tag]) - -len(table[tag]) % 4 + 12 + 16 * n
    font = b'\0\1\0\0' + pack('>HHHH', n, 16 << power, power, 16 * (n - (1 << power))) + b''.join(rows) + body
    return font[:head + 8] + pack('>I', 0xb1b0afba - sum_of(font) & 0xffffffff) + font[head + 12:]


def plain_text(glyphs):
    """WeasyPrint lets a glyph stand for all text since the glyph before it where it comes first, also for a character that joins
    words and is not drawn, and so in the whole document: the glyph would be copied and searched with it."""
    for glyph, text in glyphs.items():
        glyphs[glyph] = text.replace('\u2060', '') or text


def use_few_glyphs():
    """Where WeasyPrint is of a version that has this method."""
    try:
        from weasyprint.pdf.stream import Font
        by_weasyprint = Font.clean
    except (ImportError, AttributeError):
        return

    def clean(self, cmap):
        plain_text(self.cmap)
        few = few_glyphs(self.file_content, self.index, cmap) if cmap and self.ttfont else None
        if few is None:
            by_weasyprint(self, cmap)
        else:
            self.file_content = few
    Font.clean = clean


# The pages of a table of trees say mostly the same, and WeasyPrint breaks each text into lines anew for each width of a column,
# and shapes it again when it is drawn: half the time of a page. Here the lines of a text are kept for the next time. They depend
# on the text, the width and these properties alone.

OF_A_LINE = (
    'font_family', 'font_feature_settings', 'font_kerning', 'font_language_override', 'font_size', 'font_stretch', 'font_style',
    'font_variant_alternates', 'font_variant_caps', 'font_variant_east_asian', 'font_variant_ligatures', 'font_variant_numeric',
    'font_variant_position', 'font_variation_settings', 'font_weight', 'hyphenate_character', 'hyphenate_limit_chars',
    'hyphenate_limit_zone', 'hyphens', 'lang', 'letter_spacing', 'overflow_wrap', 'tab_size', 'text_decoration_line',
    'white_space', 'word_break', 'word_spacing')
KEPT = 20000  # texts, some hundred bytes each


class Lines:
    """Lines of texts in the fonts of one FontConfiguration."""
    def __init__(self, fonts, plain, layout):
        self.fonts, self.plain, self.layout = fonts, plain, layout
        self.kinds, self.kept = {}, {}

    def kind(self, style):
        try:
            return style.kind_of_line
        except AttributeError:
            properties = repr([style[name] for name in OF_A_LINE])
            kind = self.kinds.setdefault(properties, len(self.kinds))
            try:
                style.kind_of_line = kind
            except AttributeError:  # a plain dictionary
                pass
            return kind

    def split(self, text, style, context, max_width, justification_spacing, is_line_start=True, minimum=False):
        rest = max_width, justification_spacing, is_line_start, minimum
        if context is None or context.font_config is not self.fonts:
            return self.plain(text, style, context, *rest)
        key = text, self.kind(style), rest
        line = self.kept.get(key)
        if line is None:
            line = self.plain(text, style, context, *rest)
            if len(self.kept) >= KEPT:
                self.kept.clear()
            self.kept[key] = line
        own = object.__new__(self.layout)
        own.__dict__.update(line[0].__dict__, context=context)
        return own, *line[1:]


class Sheets:
    """Style sheets within pages, which are the same in most of them."""
    def __init__(self, plain):
        self.plain, self.kept = plain, {}

    def sheet(self, string=None, page_rules=None, **rest):
        if string is None or any(rule in string for rule in ('@font-face', '@import', '@counter-style')):
            return self.plain(string=string, page_rules=page_rules, **rest)
        key = string, rest.get('media_type'), rest.get('base_url')
        if key not in self.kept:
            if len(self.kept) >= 16:
                self.kept.clear()
            self.kept[key] = self.plain(string=string, page_rules=[], **rest)
        if page_rules is not None:
            page_rules += self.kept[key].page_rules
        return self.kept[key]


def keep():
    """Keep lines and style sheets. Returned: the fonts whose lines are kept; None where WeasyPrint is of another version than
    those of which this is known to be right."""
    if getattr(weasyprint, '__version__', '').split('.')[0] not in ('57', '58', '59'):
        return None
    try:
        from weasyprint import css
        from weasyprint.layout import inline, preferred
        from weasyprint.text import fonts, line_break
        lines = Lines(fonts.FontConfiguration(), line_break.split_first_line, line_break.Layout)
    except (ImportError, AttributeError):
        return None
    inline.split_first_line = preferred.split_first_line = line_break.split_first_line = lines.split
    css.CSS = Sheets(css.CSS).sheet
    return lines.fonts


# The Chinese face that is installed has no bold; this one has the characters of the program's own words.
HAN_BOLD = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'han_bold.ttf')


def with_han_bold(fonts):
    """The fonts with that face, which pages call "windfirm Han bold"; as they are where it is not there."""
    try:
        from weasyprint.text.fonts import FontConfiguration
        with open(HAN_BOLD, 'rb') as f:
            face = base64.b64encode(f.read()).decode()
        own = fonts or FontConfiguration()
        weasyprint.CSS(string='@font-face { font-family: "windfirm Han bold"; font-weight: bold; src: url(data:font/ttf;base64,%s) }' % face,
                       font_config=own, url_fetcher=fetch)
        return own
    except (OSError, ImportError, AttributeError):
        return fonts


# A last page of a few lines: margins and lines are closer where that saves the page; else wider, so that more stands on it.
CLOSER = '@page { margin-top: 16mm !important; margin-bottom: 14mm !important } html, body { line-height: 1.36 !important }'
CLOSEST = '@page { margin-top: 15mm !important; margin-bottom: 12mm !important } html, body { line-height: 1.3 !important }'
LOWER = '@page { margin-top: 15mm !important; margin-bottom: 12mm !important }'
WIDER = '@page { margin-top: 22mm !important; margin-bottom: 21mm !important }'
SPARSE, FEW = 0.3, 0.2


def filled(page):
    """The share of a page's height that its lines, rows and pictures reach."""
    low, waiting, box = 0, [page._page_box], page._page_box
    top, height = box.content_box_y(), box.height
    while waiting:
        box = waiting.pop()
        children = getattr(box, 'children', ())
        waiting += [c for c in children if not type(c).__name__.startswith('Margin')]
        if not children and box.position_y >= top:
            low = max(low, box.position_y + (box.height if isinstance(box.height, (int, float)) else 0) - top)
    return low / height


def laid_out(html, fonts):
    with_fonts = {'font_config': fonts} if fonts else {}
    document = html.render(**with_fonts)
    if len(document.pages) < 2:
        return document

    def rank(of):
        return filled(of.pages[-1]) < FEW, len(of.pages)
    try:
        if filled(document.pages[-1]) > SPARSE:
            return document
        for style in CLOSER, CLOSEST, LOWER, WIDER:
            other = html.render(stylesheets=[weasyprint.CSS(string=style)], **with_fonts)
            if rank(other) < rank(document):
                document = other
            if not rank(document)[0]:
                break
    except AttributeError:  # of another version, whose boxes have other names
        pass
    return document


def orders():
    waiting = b''
    while True:
        while waiting.count(b'\0') < 3:
            piece = os.read(0, 65536)
            if not piece:
                return
            waiting += piece
        folder, page, file, waiting = waiting.split(b'\0', 3)
        yield folder, page, file


def main():
    said = logging.StreamHandler(sys.stdout)
    said.setFormatter(logging.Formatter('%(levelname)s: %(message)s'))
    said.setLevel(logging.ERROR)
    weasyprint.LOGGER.addHandler(said)
    use_few_glyphs()
    fonts = keep()
    here = os.open('.', getattr(os, 'O_PATH', os.O_RDONLY))  # folders are named from here
    gc.freeze()
    gc.disable()  # looking for dead objects takes a tenth of the time of a page
    bold = False
    for n, (folder, page, file) in enumerate(orders()):
        if n % 8 == 7:  # each page leaves some ten megabytes, and looking takes a tenth of a second
            gc.collect()
        os.fchdir(here)
        os.chdir(folder)
        with open(page, 'rb') as f:
            html = f.read()
        if b'lang="zh"' in html and not bold:
            fonts, bold = with_han_bold(fonts), True
        own = None if b'@font-face' in html else fonts  # what a page brings is its own
        laid_out(weasyprint.HTML(string=html, encoding='utf-8', url_fetcher=fetch), own).write_pdf(os.fsdecode(file))
        sys.stdout.flush()
        os.write(1, b'\0')


if __name__ == '__main__':
    main()

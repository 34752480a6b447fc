# SPDX-License-Identifier: GPL-3.0-or-later
# A page to a PDF by WeasyPrint: python -E pdf.py PAGE.html FILE.pdf. The page carries its styles and pictures in itself;
# no other file and no address is fetched, whatever the page names.
import logging
import sys

try:
    import weasyprint
except ImportError as why:
    print(why)
    sys.exit(127)  # as a shell says of a program that is not there


def fetch(url, *args, **options):
    if not url.startswith('data:'):
        raise ValueError('only data: addresses are read')
    return weasyprint.default_url_fetcher(url, *args, **options)


told = logging.StreamHandler(sys.stdout)
told.setFormatter(logging.Formatter('%(levelname)s: %(message)s'))
told.setLevel(logging.ERROR)
weasyprint.LOGGER.addHandler(told)
with open(sys.argv[1], 'rb') as page:
    html = page.read()
weasyprint.HTML(string=html, encoding='utf-8', url_fetcher=fetch).write_pdf(sys.argv[2])

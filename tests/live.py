# SPDX-License-Identifier: GPL-3.0-or-later
# The page of a report, of runs in time or of rain in headless Chromium: moves the slider, compares its numbers with the tables of the page and with the
# results, and takes pictures of a telephone and a desk.
#   python3 live.py FOLDER CHROMIUM [PICTURES]
# Chromium is driven through pipes, so that no port is opened. Prints "live: N numbers", or what is wrong.
import base64, csv, json, os, re, subprocess, sys, tempfile, time

folder, chromium = os.path.abspath(sys.argv[1]), sys.argv[2]
pictures = sys.argv[3] if len(sys.argv) > 3 else None


class Browser:
    def __init__(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        down, up = os.pipe(), os.pipe()
        # the browser reads from 3 and writes to 4
        self.process = subprocess.Popen(
            ['sh', '-c', f'exec 3<&{down[0]} 4>&{up[1]}; exec "$@"', 'sh', chromium, '--headless=new', '--no-sandbox',
             '--disable-gpu', '--no-first-run', '--hide-scrollbars', '--remote-debugging-pipe',
             '--user-data-dir=' + self.profile.name, 'about:blank'],
            pass_fds=(down[0], up[1]), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(down[0]), os.close(up[1])
        self.to, self.back, self.rest, self.n, self.said = down[1], up[0], b'', 0, []
        page = [t for t in self.call('Target.getTargets')['targetInfos'] if t['type'] == 'page'][0]
        self.session = self.call('Target.attachToTarget', targetId=page['targetId'], flatten=True)['sessionId']
        for domain in ('Page', 'Runtime', 'Log'):
            self.call(domain + '.enable')

    def next(self):
        while b'\0' not in self.rest:
            got = os.read(self.back, 1 << 16)
            if not got:
                sys.exit('the browser ended')
            self.rest += got
        one, self.rest = self.rest.split(b'\0', 1)
        one = json.loads(one)
        if one.get('method') in ('Runtime.exceptionThrown', 'Log.entryAdded'):
            self.said.append(json.dumps(one['params'])[:600])
        return one

    def call(self, method, **params):
        self.n += 1
        order = {'id': self.n, 'method': method, 'params': params}
        if hasattr(self, 'session'):
            order['sessionId'] = self.session
        os.write(self.to, json.dumps(order).encode() + b'\0')
        while True:
            one = self.next()
            if one.get('id') == self.n:
                if 'error' in one:
                    sys.exit(f"{method}: {one['error']}")
                return one['result']

    def open(self, path):
        self.call('Page.navigate', url='file://' + path)
        while self.next().get('method') != 'Page.loadEventFired':
            pass

    def js(self, text):
        result = self.call('Runtime.evaluate', expression=text, returnByValue=True)
        if 'exceptionDetails' in result:
            sys.exit(str(result['exceptionDetails'])[:600])
        return result['result'].get('value')

    def size(self, width, height):
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1, mobile=width < 600)

    def key(self, name, code):
        for kind in ('keyDown', 'keyUp'):
            self.call('Input.dispatchKeyEvent', type=kind, key=name, code=name, windowsVirtualKeyCode=code)

    def picture(self, file):
        shot = self.call('Page.captureScreenshot', format='png', captureBeyondViewport=True)['data']
        with open(file, 'wb') as f:
            f.write(base64.b64decode(shot))

    def close(self):
        self.process.kill()
        self.process.wait()
        self.profile.cleanup()


wrong, compared = [], 0


def near(what, shown, want):
    global compared
    compared += 1
    if want is None or want == '':
        if shown != '–':
            wrong.append(f'{what}: {shown}, want a dash')
        return
    value = float(shown.replace('−', '-').replace(',', ''))
    if abs(value - float(want)) > 0.006 * abs(float(want)) + 1e-4:
        wrong.append(f'{what}: {shown}, want {want}')


def played(first=0, pace=0.9):
    """The button plays step by step from the first to the last, and pauses; with less motion it goes one step."""
    state = "document.querySelector('#live .play').getAttribute('aria-pressed')"
    at = "Number(document.querySelector('#live input').value)"
    last = int(browser.js("document.querySelector('#live input').max"))
    browser.js("document.querySelector('#live .play').focus()")
    browser.key(' ', 32)
    if browser.js(state) != 'true' or browser.js(at) != first:
        wrong.append('play does not begin at the first')
    time.sleep(1.35 * pace)
    browser.key(' ', 32)
    here = browser.js(at)
    if browser.js(state) != 'false' or here not in (first + 1, first + 2):
        wrong.append(f'play: at {here} after {1.35 * pace:.1f} s, pressed {browser.js(state)}')
    time.sleep(1.35 * pace)
    if browser.js(at) != here:
        wrong.append('play goes on after the pause')
    browser.js("document.querySelector('#live .play').click()")
    time.sleep((pace + 0.05) * (last + 1))
    if browser.js(at) != last or browser.js(state) != 'false':
        wrong.append(f'play ends at {browser.js(at)}, not {last}')
    browser.call('Emulation.setEmulatedMedia', features=[{'name': 'prefers-reduced-motion', 'value': 'reduce'}])
    browser.js("document.querySelector('#live input').focus()")
    browser.key('Home', 36)
    browser.js("document.querySelector('#live .play').click()")
    time.sleep(1.2 * pace)
    if browser.js(at) != first + 1 or browser.js(state) != 'false':
        wrong.append(f'with less motion a press goes to {browser.js(at)}')
    browser.call('Emulation.setEmulatedMedia', features=[])


def hovered(tree):
    """The top of the stem under the pointer says its height."""
    browser.js("document.querySelector('#live .stage').scrollIntoView()")
    box = browser.js("var r = document.querySelector('#live .stage svg').getBoundingClientRect(); [r.left + r.width / 2, r.top + 4]")
    browser.call('Input.dispatchMouseEvent', type='mouseMoved', x=box[0], y=box[1])
    said = browser.js("document.querySelector('#live .at').textContent")
    height = re.search(r'([\d.]+) m', said)
    near('height under the pointer', height.group(1) if height else '0', tree['height']['value'])


def turned(k, tree):
    """The arrow of the rose turns with the slider; its numbers are those of the table of directions."""
    hidden = browser.js("document.querySelector('#live .around').hidden")
    rows = [r for r in table('directions') if int(r['tree']) == k + 1]
    if hidden != (not rows):
        wrong.append(f'the rose is {"hidden" if hidden else "there"}')
    if not rows:
        return
    strongest = max(float(r['wind_m_s']) for r in rows)
    rows = [r for r in rows if float(r['wind_m_s']) == strongest]
    browser.js("document.querySelector('#live .azimuth').focus()")
    browser.key('Home', 36)
    for i, row in enumerate(rows):
        if i:
            browser.key('ArrowRight', 39)
        near('from', read('a-from'), row['from_deg'])
        near('lost', read('a-lost'), row['lost_wind_m_s'])
        near('moment from there', read('a-moment'), float(row['base_moment_Nm']) / 1e3)
        near('safety from there', read('a-safety'), row['tree_safety'])
        arrow = browser.js("document.querySelector('#live .arrow').getAttribute('transform')")
        if abs(float(arrow[7:-1]) - float(row['from_deg'])) > 1e-6:
            wrong.append(f"the arrow is at {arrow}, not {row['from_deg']}")


def winds():
    """The slider of a report: every tree at every wind."""
    summary = table('summary')
    for k, tree in enumerate(results['trees']):
        rows = [r for r in summary if int(r['tree']) == k + 1 and r['status'] == 'ok']
        browser.js(f"var c = document.querySelector('#live select'); c.value = '{k}'; c.dispatchEvent(new Event('change')); 0")
        if browser.js("document.querySelector('#live select').selectedOptions[0].textContent") != tree['species']['name']:
            wrong.append(f'tree {k + 1}: not its name')
        browser.js("document.querySelector('#live input').focus()")
        browser.key('Home', 36)
        near('still air', read('moment'), 0)
        shapes = {browser.js("document.querySelector('#live svg .bent').getAttribute('d')")}
        for row in rows:
            browser.key('ArrowRight', 39)
            near('speed', read('speed'), row['wind_m_s'])
            near('tip', read('tip'), row['mean_tip_deflection_m'] or row['tip_deflection_m'])
            near('top', read('top'), row['mean_top_deflection_m'] or row['top_deflection_m'])
            near('moment', read('moment'), float(row['base_moment_Nm']) / 1e3)
            near('breakage', read('breakage'), row['least_safety'])
            near('safety', read('safety'), row['tree_safety'])
            shapes.add(browser.js("document.querySelector('#live svg .bent').getAttribute('d')"))
            lost = row['lost_wind_m_s'] and float(row['wind_m_s']) > float(row['lost_wind_m_s'])
            if browser.js("document.querySelector('#live .beyond').hidden") == bool(lost):
                wrong.append(f"{row['wind_m_s']} m/s: beyond the loss or not")
        if len(shapes) != len(rows) + 1:
            wrong.append(f'{len(shapes)} shapes of {len(rows)} winds and still air')
        browser.js("document.querySelector('#live .switch').click()")
        near('after the switch', read('moment'), 0)
        browser.js("document.querySelector('#live .switch').click()")
        played()
        hovered(tree)
        turned(k, tree)


def table(name):
    path = f'{folder}/tables/{name}.csv'
    return list(csv.DictReader(open(path))) if os.path.exists(path) else []


def frames():
    """The slider of a page of runs: every key frame of every run that has several."""
    drawn, course = table('frames'), table('series')
    for k, run in enumerate(results['runs']):
        mine = [r for r in drawn if int(r['run']) == k + 1]
        there = browser.js(f"Array.from(document.querySelectorAll('#live option')).some(function (o) {{ return o.value === '{k}'; }})")
        if there != (run['keys'] > 1):
            wrong.append(f'run {k + 1}: can be chosen: {there}')
        if not there:
            continue
        browser.js(f"var c = document.querySelector('#live select'); c.value = '{k}'; c.dispatchEvent(new Event('change')); 0")
        if int(browser.js("document.querySelector('#live input').max")) != run['keys']:
            wrong.append(f'run {k + 1}: not {run["keys"]} frames')
        browser.js("document.querySelector('#live input').focus()")
        browser.key('Home', 36)
        for key in range(1, run['keys'] + 1):
            if key > 1:
                browser.key('ArrowRight', 39)
            rows = [r for r in mine if int(r['key']) == key]
            now = [r for r in course if int(r['run']) == k + 1 and r['time_s'] == rows[0]['time_s']][0]
            near('time', read('time'), now['time_s'])
            near('wind', read('wind'), now['wind_m_s'])
            near('tip', read('tip'), now['tip_deflection_m'])
            near('moment', read('moment'), float(now['base_moment_N_m']) / 1e3)
            near('safety', read('safety'), now['safety'])
            line = browser.js("document.querySelector('#live svg .bent').getAttribute('d')").split('M')[1:]
            stems = not browser.js("document.querySelector('#live .stems').hidden")
            rows = [r for r in rows if not stems or r['level'] == '0']
            if len(line) != len(rows):
                wrong.append(f'run {k + 1}, frame {key}: {len(line)} segments, not {len(rows)}')
            end = [float(x) for x in line[-1].split('L')[1].split()]
            if abs(end[0] - float(rows[-1]['along1_m'])) > 1e-4 or abs(end[1] + float(rows[-1]['z1_m'])) > 1e-4:
                wrong.append(f'run {k + 1}, frame {key}: ends at {end}')
            if browser.js("document.querySelector('#live .beyond').hidden") == (now['beyond_breakage'] == '1'):
                wrong.append(f'run {k + 1}, frame {key}: broken or not')
        played(1, 0.7)


def rain():
    """The slider of a page of rain: every key frame of every run; its numbers, its last line, the way drawn longer."""
    drawn, keys, course, air = table('scene'), table('keys'), table('series'), table('air')
    for k, run in enumerate(results['runs']):
        mine = [r for r in keys if int(r['run']) == k + 1]
        if run['keys'] != len(mine):
            wrong.append(f'run {k + 1}: {run["keys"]} key frames, {len(mine)} in the table')
        browser.js(f"var c = document.querySelector('#live select'); c.value = '{k}'; c.dispatchEvent(new Event('change')); 0")
        if int(browser.js("document.querySelector('#live input').max")) != len(mine) - 1:
            wrong.append(f'run {k + 1}: not {len(mine)} frames')
        browser.js("document.querySelector('#live input').focus()")
        browser.key('Home', 36)
        words = set()
        for i, row in enumerate(mine):
            if i:
                browser.key('ArrowRight', 39)
            now = [r for r in course if int(r['run']) == k + 1 and float(r['time_s']) >= float(row['time_s']) - 1e-6][0]
            near('time', read('time'), row['time_s'])
            near('leaf', read('leaf'), row['leaf'])
            near('drops', read('drops'), row['drops'])
            for key, column in (('held', 'held_mg'), ('film', 'film_mg'), ('fell', 'fell_mg'), ('tip', 'tip_up_mm'),
                                ('moment', 'branch_moment_mNm')):
                near(key, read(key), now[column])
            words.add((row['event'], read('event')))
            for longer in (False, True):
                browser.js(f"var w = document.querySelector('#live .way'); w.checked = {str(longer).lower()}; w.dispatchEvent(new Event('change')); 0")
                factor = int(re.search(r'\d+', browser.js("document.querySelector('#live .times').textContent")).group())
                if not longer and factor != 1:
                    wrong.append(f'run {k + 1}: drawn {factor} times as long')
                for kind in ('branch', 'edge'):
                    here, last = ([r for r in drawn if (int(r['run']), int(r['key']), r['kind']) == (k + 1, n, kind)]
                                  for n in (i + 1, len(mine)))
                    line = browser.js(f"document.querySelector('#live svg .now.{kind}').getAttribute('d')").split('M')[1:]
                    if len(line) != len(here):
                        wrong.append(f'run {k + 1}, frame {i + 1}: {len(line)} lines, not {len(here)}')
                    end = [float(x) for x in line[-1].split('L')[1].split()]
                    want = [float(last[-1][c]) + factor * (float(here[-1][c]) - float(last[-1][c])) for c in ('x1_m', 'z1_m')]
                    if abs(end[0] - want[0]) > 2e-5 * factor or abs(end[1] + want[1]) > 2e-5 * factor:
                        wrong.append(f'run {k + 1}, frame {i + 1}, {kind}: ends at {end}, not {want}')
            if len(browser.js("document.querySelector('#live svg .air').getAttribute('d')").split('M')[1:]) != len(
                    [r for r in air if (int(r['run']), int(r['key'])) == (k + 1, i + 1)]):
                wrong.append(f'run {k + 1}, frame {i + 1}: not its drops in the air')
        if len({e for e, _ in words}) != len({w for _, w in words}) or '' in [w for _, w in words]:
            wrong.append(f'run {k + 1}: events have the words {words}')
        at = "Number(document.querySelector('#live input').value)"
        places = [browser.js(f"document.querySelector('#live .switch').click(); {at}") for _ in range(2)]
        if places != [0, len(mine) - 1]:
            wrong.append(f'run {k + 1}: the switch goes to {places}')
        played(0, 0.7)


results = json.load(open(folder + '/results.json'))
kind = results['schema']['name']
page, look = {'windfirm-series': ('series', frames), 'windfirm-rain': ('rain', rain)}.get(kind, ('report', winds))
browser = Browser()
browser.open(f'{folder}/{page}.html')
read = lambda key: browser.js(f"document.querySelector('#live [data-key={key}]').textContent")
if browser.js("document.getElementById('live').hidden"):
    wrong.append('the picture stays hidden')
look()
for name, width, height in (('phone', 390, 844), ('desk', 1280, 900)):
    browser.size(width, height)
    wide = browser.js("document.documentElement.scrollWidth")
    if wide > width:
        wrong.append(f'{name}: the page is {wide} pixels wide, not {width}')
    out = browser.js("""Array.from(document.querySelectorAll('p, caption, figcaption, h1, h2, h3, li, table, figure')).filter(function (x) {
        var r = x.getBoundingClientRect(); var box = x.closest('.data, figure');
        return r.width && r.right > %d + 1 && (!box || box === x); }).map(function (x) { return x.tagName + ' ' + x.textContent.slice(0, 40); }).join('; ')""" % width)
    if out:
        wrong.append(f'{name}: beyond the edge: {out[:300]}')
    if pictures:
        browser.picture(f'{pictures}/{name}.png')
if browser.js("document.title").startswith('x'):
    wrong.append('the title was changed by a name')
wrong += browser.said
browser.close()
print('\n'.join(wrong) if wrong else f'live: {compared} numbers')
sys.exit(bool(wrong))

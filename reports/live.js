/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The picture of a report that answers: the tree at the wind of a slider, played wind by wind, and the winds from all around;
 * their numbers. It reads the data that stands in the page, asks nobody for anything and writes text alone. */
'use strict';
(function () {
  var box = picture.box, data = picture.data, put = picture.put, unit = picture.unit, number = picture.number;
  if (!box || !data.trees.length) { return; }
  var slider = box.querySelector('input[type=range]');
  var choice = box.querySelector('select');
  var svg = put(box.querySelector('.stage'), 'svg', { role: 'img' });
  var tree = data.trees[0];
  var at = 0, kept = 0;
  var shown = picture.quantities({ speed: 'm/s', gust: 'm/s', tip: 'm', top: 'm', moment: 'kN m', 'a-lost': 'm/s',
    'a-moment': 'kN m' });
  function wind(w) { return number(shown('speed', w ? w.speed : 0)) + ' ' + unit('m/s')[1]; }
  function path(axes) {
    return axes.map(function (a) {
      return a.map(function (p, i) { return (i ? 'L' : 'M') + p[0] + ' ' + -p[1]; }).join('');
    }).join('');
  }
  /* the room that all shapes of all trees take */
  var room = picture.room(svg, function (point) {
    data.trees.forEach(function (t) {
      [t.still].concat(t.winds.map(function (w) { return w.axes; })).forEach(function (axes) {
        axes.forEach(function (a) { a.forEach(function (p) { point(p[0], p[1]); }); });
      });
    });
  });

  function draw() {
    var w = at ? tree.winds[at - 1] : null, thin = room.thin;
    var lost = w && tree.lost !== null && w.speed > tree.lost;
    picture.begin(svg, room);
    put(svg, 'path', { d: path(tree.still), fill: 'none', stroke: '#888', 'stroke-width': thin, 'stroke-dasharray': 4 * thin });
    put(svg, 'path', { d: path(w ? w.axes : tree.still), fill: 'none', stroke: lost ? '#D55E00' : '#0072B2',
      'stroke-width': 2 * thin, 'stroke-linejoin': 'round', 'class': 'bent' });
    svg.setAttribute('aria-label', wind(w));
    ['speed', 'gust', 'tip', 'top', 'moment', 'breakage', 'safety'].forEach(function (key) {
      box.querySelector('[data-key=' + key + ']').textContent = w ? number(shown(key, w[key])) : key === 'breakage' || key === 'safety' ? '–' : '0';
    });
    box.querySelector('.beyond').hidden = !lost;
    slider.value = at;
    slider.setAttribute('aria-valuetext', wind(w));
  }
  function go(i) { at = i; kept = at || kept; draw(); }
  var stop = picture.player(900, 0, function () { return tree.winds.length; }, function () { return at; }, go);

  /* the point of the stem under the pointer: its height, and how far it has moved */
  var said = box.querySelector('.at');
  function measure(x) { return number(unit('m')[0] * x) + ' ' + unit('m')[1]; }
  svg.addEventListener('pointermove', function (event) {
    var w = at ? tree.winds[at - 1] : null, matrix = svg.getScreenCTM(), best = null;
    if (!matrix || !tree.still.length) { return; }
    var p = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    var stem = (w ? w.axes : tree.still)[0] || [];
    stem.forEach(function (q, i) {
      var far = Math.hypot(q[0] - p.x, -q[1] - p.y);
      if (best === null || far < best.far) { best = { far: far, i: i }; }
    });
    var still = best && tree.still[0][best.i];
    if (!still) { return; }
    said.textContent = said.getAttribute('data-words').replace('%1', measure(still[1]))
      .replace('%2', measure(Math.hypot(stem[best.i][0] - still[0], stem[best.i][1] - still[1])));
  });

  /* winds from all around: an arrow that turns with the slider */
  var around = box.querySelector('.around'), turn = box.querySelector('.azimuth');
  var rose = put(box.querySelector('.rose'), 'svg', { role: 'img', viewBox: '-130 -130 260 260' });
  function spot(from, r) {
    var a = from * Math.PI / 180;
    return [r * Math.sin(a), -r * Math.cos(a)];
  }
  function drawRose() {
    var list = tree.around, most = 0;
    around.hidden = !list.length;
    if (!list.length) { return; }
    var d = list[Number(turn.value)];
    picture.clear(rose);
    list.forEach(function (x) { most = Math.max(most, x.lost || 0); });
    [0.5, 1].forEach(function (r) {
      put(rose, 'circle', { cx: 0, cy: 0, r: 100 * r, fill: 'none', stroke: '#ccc' });
      if (most) {
        put(rose, 'text', { x: 3, y: -100 * r - 3, 'font-size': 9, fill: '#444' },
          number(shown('a-lost', r * most)) + (r === 1 ? ' ' + unit('m/s')[1] : ''));
      }
    });
    var line = list.map(function (x) { return x.lost ? spot(x.from, 100 * x.lost / most) : null; });
    put(rose, 'path', { 'class': 'lost', fill: 'none', stroke: '#D55E00', 'stroke-width': 1.5, d: line.map(function (p, i) {
      var q = line[(i + 1) % line.length];
      return p && q ? 'M' + p + 'L' + q : '';
    }).join('') });
    line.forEach(function (p, i) {
      if (!p) { return; }
      var dot = put(rose, 'circle', { cx: p[0], cy: p[1], r: 3, fill: '#D55E00' });
      put(dot, 'title', {}, number(list[i].from) + '°: ' + number(shown('a-lost', list[i].lost)) + ' ' + unit('m/s')[1]);
      dot.addEventListener('pointerenter', function () { turn.value = i; drawRose(); });
    });
    var arrow = put(rose, 'g', { 'class': 'arrow', transform: 'rotate(' + d.from + ')' });
    put(arrow, 'path', { d: 'M0-122V-40', stroke: '#0072B2', 'stroke-width': 3, fill: 'none' });
    put(arrow, 'path', { d: 'M-6-46L0-28L6-46Z', fill: '#0072B2' });
    put(rose, 'circle', { cx: 0, cy: 0, r: 5, fill: '#444' });
    put(rose, 'text', { x: -118, y: -112, 'font-size': 10, fill: '#444' }, '↑ ' + rose.parentNode.getAttribute('data-north'));
    [['a-from', d.from], ['a-lost', d.lost], ['a-moment', d.moment], ['a-safety', d.safety]].forEach(function (pair) {
      box.querySelector('[data-key=' + pair[0] + ']').textContent =
        pair[0] === 'a-from' ? String(Math.round(10 * pair[1]) / 10) : number(shown(pair[0], pair[1]));
    });
    rose.setAttribute('aria-label', number(d.from) + '°');
    turn.setAttribute('aria-valuetext', number(d.from) + '°');
  }
  turn.addEventListener('input', drawRose);

  function take(t) {
    tree = data.trees[t];
    stop();
    slider.max = tree.winds.length;
    turn.max = tree.around.length - 1;
    turn.value = 0;
    drawRose();
    at = kept = Math.min(kept || tree.winds.length, tree.winds.length);
    draw();
  }
  choice.parentNode.hidden = data.trees.length < 2;
  choice.addEventListener('change', function () { take(Number(choice.value)); });
  slider.addEventListener('input', function () { stop(); go(Number(slider.value)); });
  box.querySelector('.switch').addEventListener('click', function () { stop(); at = at ? 0 : kept; draw(); });
  box.hidden = false;
  take(0);
}());

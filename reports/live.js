/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The picture of a report that answers: the tree at the wind of a slider, and its numbers. It reads the data that stands
 * in the page, asks nobody for anything and writes text alone. */
'use strict';
(function () {
  var box = document.getElementById('live');
  var data = JSON.parse(document.getElementById('live-data').textContent);
  if (!box || !data.trees.length) { return; }
  var NS = 'http://www.w3.org/2000/svg';
  var slider = box.querySelector('input[type=range]');
  var choice = box.querySelector('select');
  var svg = put(box.querySelector('.stage'), 'svg', { role: 'img' });
  var tree = data.trees[0];
  var at = 0, kept = 0;

  function put(parent, name, attributes, text) {
    var x = document.createElementNS(NS, name);
    Object.keys(attributes).forEach(function (k) { x.setAttribute(k, attributes[k]); });
    if (text !== undefined) { x.textContent = text; }
    parent.appendChild(x);
    return x;
  }
  /* a number of the results in the units of the page, and what they are called */
  function unit(name) { return data.units[name] || [1, name]; }
  var measured = { speed: 'm/s', gust: 'm/s', tip: 'm', moment: 'kN m' };
  function shown(key, x) { return measured[key] && x !== null ? unit(measured[key])[0] * x : x; }
  function wind(w) { return number(shown('speed', w ? w.speed : 0)) + ' ' + unit('m/s')[1]; }
  Object.keys(measured).forEach(function (key) {
    box.querySelector('[data-key=' + key + ']').nextSibling.textContent = ' ' + unit(measured[key])[1];
  });
  /* three significant digits, as in the tables */
  function number(x) {
    if (x === null || x === undefined) { return '–'; }
    var size = Math.abs(x);
    var text = x.toFixed(size >= 99.95 || size === 0 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 ? 2 : size >= 0.09995 ? 3 : 4);
    return text.replace('-', '−');
  }
  function path(axes) {
    return axes.map(function (a) {
      return a.map(function (p, i) { return (i ? 'L' : 'M') + p[0] + ' ' + -p[1]; }).join('');
    }).join('');
  }
  /* the room that all shapes of all trees take */
  var low = 0, high = 0, top = 0, floor = 0;
  data.trees.forEach(function (t) {
    [t.still].concat(t.winds.map(function (w) { return w.axes; })).forEach(function (axes) {
      axes.forEach(function (a) {
        a.forEach(function (p) {
          low = Math.min(low, p[0]); high = Math.max(high, p[0]);
          floor = Math.min(floor, p[1]); top = Math.max(top, p[1]);
        });
      });
    });
  });
  var side = Math.max(high - low, 0.9 * top), middle = 0.5 * (low + high), edge = 0.08 * top;
  low = middle - 0.5 * side; high = middle + 0.5 * side;
  svg.setAttribute('viewBox', [low - 2 * edge, -top - edge, side + 3 * edge, top - floor + 2 * edge].join(' '));

  function draw() {
    var w = at ? tree.winds[at - 1] : null;
    var thin = 0.004 * top;
    var lost = w && tree.lost !== null && w.speed > tree.lost;
    while (svg.lastChild) { svg.removeChild(svg.lastChild); }
    var scale = unit('m')[0];
    var step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].filter(function (s) { return s >= scale * top / 6; })[0] || scale * top;
    for (var tick = 0, z = 0; z <= top; tick += step, z = tick / scale) {
      put(svg, 'line', { x1: low - 0.4 * edge, x2: high, y1: -z, y2: -z, stroke: '#ddd', 'stroke-width': thin / 2 });
      put(svg, 'text', { x: low - 0.5 * edge, y: -z + 0.015 * top, 'font-size': 0.045 * top, 'text-anchor': 'end', fill: '#444' },
        Number(tick.toFixed(2)) + (tick ? '' : ' ' + unit('m')[1]));
    }
    put(svg, 'path', { d: path(tree.still), fill: 'none', stroke: '#888', 'stroke-width': thin, 'stroke-dasharray': 4 * thin });
    put(svg, 'path', { d: path(w ? w.axes : tree.still), fill: 'none', stroke: lost ? '#D55E00' : '#0072B2',
      'stroke-width': 2 * thin, 'stroke-linejoin': 'round', 'class': 'bent' });
    svg.setAttribute('aria-label', wind(w));
    ['speed', 'gust', 'tip', 'moment', 'breakage', 'safety'].forEach(function (key) {
      box.querySelector('[data-key=' + key + ']').textContent = w ? number(shown(key, w[key])) : key === 'breakage' || key === 'safety' ? '–' : '0';
    });
    box.querySelector('.beyond').hidden = !lost;
    slider.value = at;
    slider.setAttribute('aria-valuetext', wind(w));
  }
  function take(t) {
    tree = data.trees[t];
    slider.max = tree.winds.length;
    at = kept = Math.min(kept || tree.winds.length, tree.winds.length);
    draw();
  }
  choice.parentNode.hidden = data.trees.length < 2;
  choice.addEventListener('change', function () { take(Number(choice.value)); });
  slider.addEventListener('input', function () { at = Number(slider.value); kept = at || kept; draw(); });
  box.querySelector('button').addEventListener('click', function () { at = at ? 0 : kept; draw(); });
  box.hidden = false;
  take(0);
}());

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the pictures with a slider share (live.js, frames.js, rain.js, one of which stands behind it in the page): the data of the page,
 * numbers in its units, the room that shapes take, the button that plays them, and key frames of runs. */
'use strict';
var picture = (function () {
  var NS = 'http://www.w3.org/2000/svg';
  var box = document.getElementById('live');
  var data = JSON.parse(document.getElementById('live-data').textContent);

  function put(parent, name, attributes, text) {
    var x = document.createElementNS(NS, name);
    Object.keys(attributes).forEach(function (k) { x.setAttribute(k, attributes[k]); });
    if (text !== undefined) { x.textContent = text; }
    parent.appendChild(x);
    return x;
  }
  function clear(svg) {
    while (svg.lastChild) { svg.removeChild(svg.lastChild); }
  }
  /* a number of the results in the units of the page, and what they are called */
  function unit(name) { return data.units[name] || [1, name]; }
  /* measured: the unit of each number that has one; its name behind the numbers, and the numbers in it */
  function quantities(measured) {
    Object.keys(measured).forEach(function (key) {
      box.querySelector('[data-key=' + key + ']').nextSibling.textContent = ' ' + unit(measured[key])[1];
    });
    return function (key, x) { return measured[key] && x !== null && x !== undefined ? unit(measured[key])[0] * x : x; };
  }
  /* three significant digits, as in the tables */
  function number(x) {
    if (x === null || x === undefined) { return '–'; }
    var size = Math.abs(x);
    var text = x.toFixed(size >= 99.95 || size === 0 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 ? 2 : size >= 0.09995 ? 3 : 4);
    return text.replace('-', '−');
  }
  function seconds(x) { return String(Number(x.toPrecision(7))); }
  /* segments, each its own stroke: x, z of the base, x, z of the end */
  function path(lines) {
    var d = '';
    for (var i = 0; i + 3 < lines.length; i += 4) {
      d += 'M' + lines[i] + ' ' + -lines[i + 1] + 'L' + lines[i + 2] + ' ' + -lines[i + 3];
    }
    return d;
  }
  /* The room of all points, of which `each` calls its argument with x and height; aloft: without the way down to the ground. */
  function room(svg, each, aloft) {
    var far = aloft ? Infinity : 0, low = far, high = -far, top = -far, floor = far;
    each(function (x, z) {
      low = Math.min(low, x); high = Math.max(high, x);
      floor = Math.min(floor, z); top = Math.max(top, z);
    });
    var tall = aloft ? Math.max(top - floor, 0.5 * (high - low)) : top;
    var side = Math.max(high - low, 0.9 * tall), middle = 0.5 * (low + high), edge = 0.08 * tall;
    low = middle - 0.5 * side; high = middle + 0.5 * side;
    svg.setAttribute('viewBox', [low - 2 * edge, -top - edge, side + 3 * edge, top - floor + 2 * edge].join(' '));
    return { low: low, high: high, from: aloft ? floor : 0, top: top, tall: tall, edge: edge, thin: 0.004 * tall };
  }
  /* An empty picture with lines at round heights. */
  function begin(svg, r) {
    var scale = unit('m')[0];
    var step = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].filter(function (s) { return s >= scale * r.tall / 6; })[0] ||
      scale * r.tall;
    clear(svg);
    for (var first = Math.ceil(scale * r.from / step - 1e-9), k = first, z = k * step / scale; step && z <= r.top; z = ++k * step / scale) {
      put(svg, 'line', { x1: r.low - 0.4 * r.edge, x2: r.high, y1: -z, y2: -z, stroke: '#ddd', 'stroke-width': r.thin / 2 });
      put(svg, 'text', { x: r.low - 0.5 * r.edge, y: -z + 0.015 * r.tall, 'font-size': 0.045 * r.tall, 'text-anchor': 'end',
        fill: '#444' }, Number((k * step).toFixed(2)) + (k > first ? '' : ' ' + unit('m')[1]));
    }
  }
  /* One after the other, every `delay` ms from `first` to last(), by at() and go(i); who asked for less motion gets one step a
   * press. Returned: what stops it. */
  function player(delay, first, last, at, go) {
    var play = box.querySelector('.play'), words = [play.textContent, play.getAttribute('data-pause')], timer = null;
    var calm = window.matchMedia('(prefers-reduced-motion: reduce)');
    function stop() {
      if (timer !== null) { window.clearInterval(timer); }
      timer = null;
      play.textContent = words[0];
      play.setAttribute('aria-pressed', 'false');
    }
    function step() {
      go(at() < last() ? at() + 1 : first);
      if (at() === last()) { stop(); }
    }
    play.addEventListener('click', function () {
      if (timer !== null) { stop(); return; }
      if (calm.matches) { step(); return; }
      if (at() === last()) { go(first); }
      timer = window.setInterval(step, delay);
      play.textContent = words[1];
      play.setAttribute('aria-pressed', 'true');
    });
    return stop;
  }
  /* Runs with their key frames: one is chosen and one of its frames drawn. first: the first frame that stands alone; shapes(k):
   * the lines of a frame; draw(keys, at, room) draws frame `at` and says what it is. Returned: what draws again. */
  function frames(svg, first, aloft, shapes, draw) {
    var slider = box.querySelector('input[type=range]'), choice = box.querySelector('select');
    var keys = [], at = first, kept = first, place = null, before = box.querySelector('.switch');
    function go(i) {
      at = i;
      if (at > first) { kept = at; }
      slider.value = at;
      var words = draw(keys, at, place);
      svg.setAttribute('aria-label', words);
      slider.setAttribute('aria-valuetext', words);
    }
    var stop = player(700, first, function () { return keys.length - 1; }, function () { return at; }, go);
    function take() {
      stop();
      kept = first;
      keys = data.runs[Number(choice.value)].keys;
      slider.min = first;
      slider.max = keys.length - 1;
      place = room(svg, function (point) {
        keys.forEach(function (k) {
          shapes(k).forEach(function (lines) {
            for (var i = 0; i + 1 < lines.length; i += 2) { point(lines[i], lines[i + 1]); }
          });
        });
      }, aloft);
      go(first);
    }
    /* of the runs, those of which several key frames stand in the page */
    Array.from(choice.options).forEach(function (o) {
      var run = data.runs[Number(o.value)];
      if (!run || !run.keys || run.keys.length < first + 2) { o.remove(); }
    });
    if (choice.options.length) {
      choice.selectedIndex = 0;
      choice.parentNode.hidden = choice.options.length < 2;
      choice.addEventListener('change', take);
      slider.addEventListener('input', function () { stop(); go(Number(slider.value)); });
      if (before) { before.addEventListener('click', function () { stop(); go(at > first ? first : kept); }); }
      box.hidden = false;
      take();
    }
    return function () { go(at); };
  }
  return { box: box, data: data, put: put, clear: clear, unit: unit, quantities: quantities, number: number,
    seconds: seconds, path: path, room: room, begin: begin, player: player, frames: frames };
}());

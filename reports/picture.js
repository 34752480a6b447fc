/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the pictures with a slider share (live.js, frames.js, one of which stands behind it in the page): the data of the page,
 * numbers in its units, the room that shapes take, and the button that plays them. */
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
  /* The room of all points, of which `each` calls its argument with x and height. */
  function room(svg, each) {
    var low = 0, high = 0, top = 0, floor = 0;
    each(function (x, z) {
      low = Math.min(low, x); high = Math.max(high, x);
      floor = Math.min(floor, z); top = Math.max(top, z);
    });
    var side = Math.max(high - low, 0.9 * top), middle = 0.5 * (low + high), edge = 0.08 * top;
    low = middle - 0.5 * side; high = middle + 0.5 * side;
    svg.setAttribute('viewBox', [low - 2 * edge, -top - edge, side + 3 * edge, top - floor + 2 * edge].join(' '));
    return { low: low, high: high, top: top, edge: edge, thin: 0.004 * top };
  }
  /* An empty picture with lines at round heights. */
  function begin(svg, r) {
    var scale = unit('m')[0];
    var step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].filter(function (s) { return s >= scale * r.top / 6; })[0] || scale * r.top;
    clear(svg);
    for (var tick = 0, z = 0; step && z <= r.top; tick += step, z = tick / scale) {
      put(svg, 'line', { x1: r.low - 0.4 * r.edge, x2: r.high, y1: -z, y2: -z, stroke: '#ddd', 'stroke-width': r.thin / 2 });
      put(svg, 'text', { x: r.low - 0.5 * r.edge, y: -z + 0.015 * r.top, 'font-size': 0.045 * r.top, 'text-anchor': 'end',
        fill: '#444' }, Number(tick.toFixed(2)) + (tick ? '' : ' ' + unit('m')[1]));
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
  return { box: box, data: data, put: put, clear: clear, unit: unit, quantities: quantities, number: number, room: room,
    begin: begin, player: player };
}());

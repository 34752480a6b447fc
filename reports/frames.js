/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key frames of a run in time, one after the other: a slider and a button that plays them, with their numbers. It reads
 * the data that stands in the page, asks nobody for anything and writes text alone. */
'use strict';
(function () {
  var box = document.getElementById('live');
  var data = JSON.parse(document.getElementById('live-data').textContent);
  if (!box) { return; }
  var NS = 'http://www.w3.org/2000/svg';
  var slider = box.querySelector('input[type=range]');
  var choice = box.querySelector('select');
  var svg = put(box.querySelector('.stage'), 'svg', { role: 'img' });
  var keys = [], at = 1, low = 0, high = 0, top = 0, floor = 0, edge = 0;

  function put(parent, name, attributes, text) {
    var x = document.createElementNS(NS, name);
    Object.keys(attributes).forEach(function (k) { x.setAttribute(k, attributes[k]); });
    if (text !== undefined) { x.textContent = text; }
    parent.appendChild(x);
    return x;
  }
  /* a number of the results in the units of the page, and what they are called */
  function unit(name) { return data.units[name] || [1, name]; }
  var measured = { time: 's', wind: 'm/s', tip: 'm', moment: 'kN m', safety: '' };
  function shown(key, x) { return x === null || x === undefined ? x : unit(measured[key])[0] * x; }
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
  function seconds(x) { return String(Number(x.toPrecision(7))); }
  /* segments, each its own stroke: x, z of the base, x, z of the end */
  function path(lines) {
    var d = '';
    for (var i = 0; i + 3 < lines.length; i += 4) {
      d += 'M' + lines[i] + ' ' + -lines[i + 1] + 'L' + lines[i + 2] + ' ' + -lines[i + 3];
    }
    return d;
  }
  /* the room that all key frames of the run take */
  function room() {
    low = high = top = floor = 0;
    keys.forEach(function (k) {
      for (var i = 0; i + 1 < k.lines.length; i += 2) {
        low = Math.min(low, k.lines[i]); high = Math.max(high, k.lines[i]);
        floor = Math.min(floor, k.lines[i + 1]); top = Math.max(top, k.lines[i + 1]);
      }
    });
    var side = Math.max(high - low, 0.9 * top), middle = 0.5 * (low + high);
    edge = 0.08 * top;
    low = middle - 0.5 * side; high = middle + 0.5 * side;
    svg.setAttribute('viewBox', [low - 2 * edge, -top - edge, side + 3 * edge, top - floor + 2 * edge].join(' '));
  }
  function draw() {
    var k = keys[at], thin = 0.004 * top, scale = unit('m')[0];
    while (svg.lastChild) { svg.removeChild(svg.lastChild); }
    var step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].filter(function (s) { return s >= scale * top / 6; })[0] || scale * top;
    for (var tick = 0, z = 0; step && z <= top; tick += step, z = tick / scale) {
      put(svg, 'line', { x1: low - 0.4 * edge, x2: high, y1: -z, y2: -z, stroke: '#ddd', 'stroke-width': thin / 2 });
      put(svg, 'text', { x: low - 0.5 * edge, y: -z + 0.015 * top, 'font-size': 0.045 * top, 'text-anchor': 'end', fill: '#444' },
        Number(tick.toFixed(2)) + (tick ? '' : ' ' + unit('m')[1]));
    }
    put(svg, 'path', { d: path(keys[0].lines), fill: 'none', stroke: '#999', 'stroke-width': thin });
    put(svg, 'path', { d: path(k.lines), fill: 'none', stroke: k.broken ? '#777' : '#0072B2', 'stroke-width': 2 * thin,
      'stroke-linecap': 'round', 'stroke-dasharray': k.broken ? 4 * thin : 'none', 'class': 'bent' });
    Object.keys(measured).forEach(function (key) {
      box.querySelector('[data-key=' + key + ']').textContent = key === 'time' ? seconds(k.time) : number(shown(key, k[key]));
    });
    box.querySelector('.beyond').hidden = !k.broken;
    slider.value = at;
    var words = seconds(k.time) + ' s, ' + number(shown('wind', k.wind)) + ' ' + unit('m/s')[1];
    svg.setAttribute('aria-label', words);
    slider.setAttribute('aria-valuetext', words);
  }
  /* frame by frame; who asked for less motion gets one step a press */
  var play = box.querySelector('.play'), words = [play.textContent, play.getAttribute('data-pause')], timer = null;
  var calm = window.matchMedia('(prefers-reduced-motion: reduce)');
  function step() {
    at = at < keys.length - 1 ? at + 1 : 1;
    draw();
    if (at === keys.length - 1) { stop(); }
  }
  function stop() {
    if (timer !== null) { window.clearInterval(timer); }
    timer = null;
    play.textContent = words[0];
    play.setAttribute('aria-pressed', 'false');
  }
  play.addEventListener('click', function () {
    if (timer !== null) { stop(); return; }
    if (calm.matches) { step(); return; }
    if (at === keys.length - 1) { at = 1; draw(); }
    timer = window.setInterval(step, 700);
    play.textContent = words[1];
    play.setAttribute('aria-pressed', 'true');
  });
  function take() {
    stop();
    keys = data.runs[Number(choice.value)].keys;
    slider.min = at = 1;
    slider.max = keys.length - 1;
    room();
    draw();
  }
  /* of the runs, those whose key frames stand in the page */
  Array.from(choice.options).forEach(function (o) {
    var run = data.runs[Number(o.value)];
    if (!run || !run.keys || run.keys.length < 3) { o.remove(); }
  });
  if (!choice.options.length) { return; }
  choice.selectedIndex = 0;
  choice.parentNode.hidden = choice.options.length < 2;
  choice.addEventListener('change', take);
  slider.addEventListener('input', function () { stop(); at = Number(slider.value); draw(); });
  box.querySelector('.stems').hidden = !data.stems;
  box.hidden = false;
  take();
}());

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key frames of a run in time, one after the other: a slider and a button that plays them, with their numbers. It reads
 * the data that stands in the page, asks nobody for anything and writes text alone. */
'use strict';
(function () {
  var box = picture.box, data = picture.data, put = picture.put, unit = picture.unit, number = picture.number;
  if (!box) { return; }
  var slider = box.querySelector('input[type=range]');
  var choice = box.querySelector('select');
  var svg = put(box.querySelector('.stage'), 'svg', { role: 'img' });
  var keys = [], at = 1, room = null;
  var measured = { time: 's', wind: 'm/s', tip: 'm', moment: 'kN m', safety: '' };
  var shown = picture.quantities(measured);
  function seconds(x) { return String(Number(x.toPrecision(7))); }
  /* segments, each its own stroke: x, z of the base, x, z of the end */
  function path(lines) {
    var d = '';
    for (var i = 0; i + 3 < lines.length; i += 4) {
      d += 'M' + lines[i] + ' ' + -lines[i + 1] + 'L' + lines[i + 2] + ' ' + -lines[i + 3];
    }
    return d;
  }
  function draw() {
    var k = keys[at], thin = room.thin;
    picture.begin(svg, room);
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
  function go(i) { at = i; draw(); }
  var stop = picture.player(700, 1, function () { return keys.length - 1; }, function () { return at; }, go);
  function take() {
    stop();
    keys = data.runs[Number(choice.value)].keys;
    slider.min = at = 1;
    slider.max = keys.length - 1;
    /* the room that all key frames of the run take */
    room = picture.room(svg, function (point) {
      keys.forEach(function (k) {
        for (var i = 0; i + 1 < k.lines.length; i += 2) { point(k.lines[i], k.lines[i + 1]); }
      });
    });
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
  slider.addEventListener('input', function () { stop(); go(Number(slider.value)); });
  box.querySelector('.stems').hidden = !data.stems;
  box.hidden = false;
  take();
}());

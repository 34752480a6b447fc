/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key frames of rain on a branch, one after the other: branch, leaves and drops in the air, with their numbers. It reads the
 * data that stands in the page, asks nobody for anything and writes text alone. */
'use strict';
(function () {
  var box = picture.box, put = picture.put, number = picture.number;
  if (!box) { return; }
  var svg = put(box.querySelector('.stage'), 'svg', { role: 'img' });
  var measured = { time: 's', leaf: '', drops: '', held: 'mg', film: 'mg', fell: 'mg', tip: 'mm', moment: 'mN m' };
  var shown = picture.quantities(measured);
  var lines = { edge: ['#009E73', 1.2], vein: ['#7fcfb8', 0.8], petiole: ['#7a5a2f', 1.8], branch: ['#5b3d16', 3] };
  var kinds = Object.keys(lines);
  var times = box.querySelector('.times'), way = box.querySelector('.way');
  function all(k) { return kinds.map(function (kind) { return k[kind]; }); }
  /* Leaves move little: their way from the last frame is drawn as often as long as the check box and a tenth of the picture
   * allow. */
  function factor(keys, room) {
    var most = 0, last = keys[keys.length - 1];
    keys.forEach(function (k) {
      kinds.forEach(function (kind) {
        k[kind].forEach(function (x, i) { most = Math.max(most, Math.abs(x - last[kind][i])); });
      });
    });
    return [50, 20, 10, 5, 2].filter(function (f) { return way.checked && f * most <= 0.09 * (room.high - room.low); })[0] || 1;
  }
  function draw(keys, at, room) {
    var k = keys[at], last = keys[keys.length - 1], f = factor(keys, room);
    picture.begin(svg, room);
    kinds.forEach(function (kind) {
      put(svg, 'path', { d: picture.path(last[kind]), fill: 'none', stroke: '#c8c8c8', 'stroke-width': 0.7 * room.thin });
    });
    kinds.forEach(function (kind) {
      var far = k[kind].map(function (x, i) { return last[kind][i] + f * (x - last[kind][i]); });
      put(svg, 'path', { d: picture.path(far), fill: 'none', stroke: lines[kind][0], 'stroke-width': lines[kind][1] * room.thin,
        'stroke-linecap': 'round', 'class': 'now ' + kind });
    });
    put(svg, 'path', { d: picture.path(k.air), fill: 'none', stroke: '#0072B2', 'stroke-width': 2 * room.thin, 'stroke-linecap': 'round',
      'class': 'air' });
    Object.keys(measured).forEach(function (key) {
      box.querySelector('[data-key=' + key + ']').textContent = key === 'time' ? picture.seconds(k.time) :
        measured[key] ? number(shown(key, k[key])) : String(k[key]);
    });
    var event = box.querySelector('[data-event=' + k.event + ']').textContent;
    box.querySelector('[data-key=event]').textContent = event;
    times.textContent = times.getAttribute('data-words').replace('%1', String(f));
    return picture.seconds(k.time) + ' s, ' + event;
  }
  var again = picture.frames(svg, 0, true, all, draw);
  way.addEventListener('change', again);
}());

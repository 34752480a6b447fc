/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key frames of a run in time, one after the other, with their numbers. It reads the data that stands in the page, asks
 * nobody for anything and writes text alone. */
'use strict';
(function () {
  var box = picture.box, data = picture.data, put = picture.put, unit = picture.unit, number = picture.number;
  if (!box) { return; }
  var svg = put(box.querySelector('.stage'), 'svg', { role: 'img' });
  var measured = { time: 's', wind: 'm/s', tip: 'm', moment: 'kN m', safety: '' };
  var shown = picture.quantities(measured);
  function draw(keys, at, room) {
    var k = keys[at], thin = room.thin, path = picture.path;
    picture.begin(svg, room);
    put(svg, 'path', { d: path(keys[0].lines), fill: 'none', stroke: '#999', 'stroke-width': thin });
    put(svg, 'path', { d: path(k.lines), fill: 'none', stroke: k.broken ? '#777' : '#0072B2', 'stroke-width': 2 * thin,
      'stroke-linecap': 'round', 'stroke-dasharray': k.broken ? 4 * thin : 'none', 'class': 'bent' });
    Object.keys(measured).forEach(function (key) {
      box.querySelector('[data-key=' + key + ']').textContent =
        key === 'time' ? picture.seconds(k.time) : number(shown(key, k[key]));
    });
    box.querySelector('.beyond').hidden = !k.broken;
    return picture.seconds(k.time) + ' s, ' + number(shown('wind', k.wind)) + ' ' + unit('m/s')[1];
  }
  /* frame 0 is the unloaded tree */
  picture.frames(svg, 1, false, function (k) { return [k.lines]; }, draw);
  box.querySelector('.stems').hidden = !data.stems;
}());

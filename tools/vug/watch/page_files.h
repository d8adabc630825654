// SPDX-License-Identifier: Apache-2.0
// The files of the page of `vug watch`.
#pragma once

#include <array>

namespace vug::cli {

struct PageFile {
  const char* name;  ///< After the token.
  const char* type;  ///< MIME type.
  const char* text;
};

inline constexpr PageFile kPageHtml{"", "text/html; charset=utf-8", R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<title>vug watch</title>
<link rel="stylesheet" href="page.css">
<main><img id="picture" alt="The picture of the scene" draggable="false"></main>
<aside>
<h1 id="title"></h1>
<nav role="group" aria-label="View">
<button data-view="picture" aria-pressed="true">Picture</button>
<button data-view="orbit" aria-pressed="false">Orbit</button>
<button data-view="clay" aria-pressed="false">Clay</button>
</nav>
<div id="eye" hidden>
<p>Drag to turn around the target, with Shift to move both, and use the wheel to go nearer.</p>
<textarea id="camera" rows="3" readonly aria-label="Camera for the scene"></textarea>
<button id="copy">Copy</button> <button id="home">Back to the camera</button>
</div>
<p id="status" role="status">The first picture is being rendered.</p>
<p id="work"></p>
<ul id="problems"></ul>
</aside>
<script src="page.js"></script>
</html>
)"};

inline constexpr PageFile kPageCss{"page.css", "text/css", R"(
body { margin: 0; display: flex; height: 100vh; background: #202022; color: #dcdcdc;
       font: 15px/1.45 system-ui, sans-serif; }
main { flex: 1; display: flex; align-items: center; justify-content: center; min-width: 0; }
img { max-width: 100%; max-height: 100vh; width: 100%; object-fit: contain; }
img:not([src]) { visibility: hidden; }
aside { width: 22em; padding: 1em 1.2em; overflow: auto; background: #2a2a2d; }
h1 { font-size: 1.1em; margin: 0; }
#work { color: #a5a5a5; }
ul { list-style: none; padding: 0; }
li { margin: 0 0 0.9em; padding-left: 0.7em; border-left: 3px solid #d8a83c; }
li.error { border-color: #e0604f; }
li code { display: block; color: #a5a5a5; overflow-wrap: anywhere; }
.stale img { opacity: 0.55; }
.looking img { cursor: grab; touch-action: none; }
nav { margin: 0.8em 0; }
button { font: inherit; color: inherit; background: #3a3a3f; border: 1px solid #55555c;
         border-radius: 4px; padding: 0.2em 0.7em; }
button[aria-pressed=true] { background: #5a6b86; }
textarea { width: 100%; box-sizing: border-box; background: #202022; color: inherit; }
)"};

inline constexpr PageFile kPageJs{"page.js", "text/javascript", R"('use strict';
const part = (id) => document.getElementById(id);

function problem(each) {
  const item = document.createElement('li');
  item.className = each.error ? 'error' : 'warning';
  const where = document.createElement('code');
  where.textContent = each.where;
  item.append(where, each.message + (each.hint ? '. ' + each.hint : ''));
  return item;
}

let shown = 0;
let state = null;
function show(news) {
  state = news;
  document.title = state.title + ' - vug watch';
  part('title').textContent = state.title;
  part('problems').replaceChildren(...state.problems.map(problem));
  const stale = state.problems.some((each) => each.error);
  document.body.classList.toggle('stale', stale);
  const isNew = state.number !== shown;
  shown = state.number;
  if (shown === 0) return;
  if (view === 'picture') {
    if (isNew) part('picture').src = 'picture.png?' + shown;
  } else if (isNew && state.complete) look();
  const seconds = state.seconds.toFixed(1) + ' s';
  part('status').textContent =
      stale ? 'The picture is that of the last version without errors.'
      : state.complete ? 'Complete after ' + seconds : 'Unfinished after ' + seconds;
  part('work').textContent = state.work;
}

// The orbit and clay views: an eye of their own, of which one look is asked for at a time.
let view = 'picture';
let eye = null, target = null, fov = 1;
let waiting = false, wanted = false;
const minus = (a, b) => a.map((x, i) => x - b[i]);
const plus = (a, b, t = 1) => a.map((x, i) => x + t * b[i]);
const length = (a) => Math.hypot(...a);

function home() {
  [eye, target, fov] = [[...state.eye], [...state.target], state.fov];
}
function cameraText() {
  const point = (p) => '(' + p.map((x) => +x.toFixed(2)).join(', ') + ')';
  return 'camera ' + (state.camera || 'main') + ' { eye ' + point(eye) + '  target ' + point(target) +
         '  fov ' + (fov * 180 / Math.PI).toFixed(0) + 'deg }';
}
async function look() {
  part('camera').value = cameraText();
  wanted = true;
  if (waiting) return;
  waiting = true;
  while (wanted && view !== 'picture') {
    wanted = false;
    const query = new URLSearchParams({fov, clay: view === 'clay' ? 1 : 0, w: 480, h: 270});
    for (const [name, at] of [['e', eye], ['t', target]])
      ['x', 'y', 'z'].forEach((axis, i) => query.set(name + axis, at[i]));
    const url = 'look.png?' + query;
    const answer = await fetch(url).catch(() => null);
    if (answer && answer.ok && view !== 'picture') {
      URL.revokeObjectURL(part('picture').src);
      part('picture').src = URL.createObjectURL(await answer.blob());
    } else if (answer && answer.status === 503) {
      wanted = true;
      await new Promise((done) => setTimeout(done, 100));
    }
  }
  waiting = false;
}
function turn(yaw, pitch) {
  const from = minus(eye, target), reach = length(from);
  const angle = Math.atan2(from[0], from[2]) - yaw;
  const height = Math.min(1.5, Math.max(-1.5, Math.asin(from[1] / reach) + pitch));
  eye = plus(target, [Math.sin(angle) * Math.cos(height), Math.sin(height),
                      Math.cos(angle) * Math.cos(height)], reach);
}
function pan(right, up) {
  const from = minus(eye, target), reach = length(from);
  const side = [from[2], 0, -from[0]], flat = length(side) || 1;
  const move = plus(side.map((x) => x * -right * reach / flat), [0, up * reach, 0]);
  [eye, target] = [plus(eye, move), plus(target, move)];
}
part('picture').addEventListener('pointerdown', (event) => {
  if (view !== 'picture') event.target.setPointerCapture(event.pointerId);
});
part('picture').addEventListener('pointermove', (event) => {
  if (view === 'picture' || !(event.buttons & 1)) return;
  const [x, y] = [event.movementX / 300, event.movementY / 300];
  event.shiftKey ? pan(-x, y) : turn(x, y);
  look();
});
part('picture').addEventListener('wheel', (event) => {
  if (view === 'picture') return;
  event.preventDefault();
  eye = plus(target, minus(eye, target), Math.exp(event.deltaY / 1000));
  look();
}, {passive: false});
for (const button of document.querySelectorAll('[data-view]'))
  button.addEventListener('click', () => {
    if (!state || state.number === 0) return;
    view = button.dataset.view;
    for (const each of document.querySelectorAll('[data-view]'))
      each.setAttribute('aria-pressed', each === button);
    part('eye').hidden = view === 'picture';
    document.body.classList.toggle('looking', view !== 'picture');
    if (!eye) home();
    if (view === 'picture') part('picture').src = 'picture.png?' + shown;
    else look();
  });
part('home').addEventListener('click', () => { home(); look(); });
part('copy').addEventListener('click', () => {
  part('camera').select();
  navigator.clipboard.writeText(part('camera').value);
});

const events = new EventSource('events');
events.onmessage = (event) => show(JSON.parse(event.data));
events.onerror = () => { part('status').textContent = 'vug watch has ended.'; };
)"};

inline constexpr std::array kPageFiles = {kPageHtml, kPageCss, kPageJs};

}  // namespace vug::cli

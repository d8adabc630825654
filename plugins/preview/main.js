// SPDX-License-Identifier: Apache-2.0
// The page: its data, the panels next to the model, and keyboard shortcuts.
import { showPanels } from './panels.js';
import { Viewer } from './viewer.js';

const byId = (id) => document.getElementById(id);
const data = JSON.parse(byId('vug-data').textContent);
const state = document.documentElement.dataset;

function trouble(sentence) {
  byId('wait').hidden = true;
  byId('trouble').hidden = false;
  byId('trouble').textContent = sentence;
  state.ready = 'without a model';
}

function bytesOf(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes.buffer;
}

function countText(count) {
  const number = (n) => n.toLocaleString('en-US').replaceAll(',', '\u202f');
  const text = `${number(count)} triangle${count === 1 ? '' : 's'}`;
  return data.triangles < data.whole ? `${text}, decimated from ${number(data.whole)}` : text;
}

function connect(viewer) {
  const toggle = (id, act) => () => {
    const on = byId(id).getAttribute('aria-pressed') !== 'true';
    byId(id).setAttribute('aria-pressed', on);
    act(on);
  };
  const acts = {
    home: () => viewer.goHome(),
    whole: () => viewer.showWhole(),
    lights: toggle('lights', (on) => viewer.useLights(on)),
    wire: toggle('wire', (on) => viewer.showEdges(on)),
    turn: toggle('turn', (on) => viewer.turn(on)),
    fold: toggle('fold', (on) => document.body.classList.toggle('folded', !on)),
  };
  for (const [id, act] of Object.entries(acts)) byId(id).addEventListener('click', act);
  byId('cut').addEventListener('input', (event) => viewer.cut(Number(event.target.value)));
  byId('bright').addEventListener('input', (event) => viewer.brighten(Number(event.target.value)));
  byId('lights').hidden = viewer.lights.length === 0;

  const slide = (id, by) => () => {
    byId(id).value = Number(byId(id).value) + by;
    byId(id).dispatchEvent(new Event('input'));
  };
  const keys = {
    h: acts.home, f: acts.whole, l: acts.lights, w: acts.wire, t: acts.turn, p: acts.fold,
    '[': slide('cut', -0.05), ']': slide('cut', 0.05),
    '-': slide('bright', -0.5), '+': slide('bright', 0.5), '=': slide('bright', 0.5),
  };
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'l' && viewer.lights.length === 0) return;
    keys[event.key.toLowerCase()]?.();
  });
}

byId('head').querySelector('h1').textContent = data.name;
showPanels(data, byId('tabs'), byId('pages'));
try {
  const viewer = new Viewer(byId('view'), data);
  viewer.load(bytesOf(byId('vug-model').textContent)).then(() => {
    byId('count').textContent = countText(viewer.triangles);
    connect(viewer);
    byId('wait').hidden = true;
    state.triangles = viewer.triangles;
    state.ready = 'yes';
  }).catch((error) => trouble(`The model cannot be shown: ${error.message}`));
} catch (error) {
  trouble('WebGL is not available, so the model cannot be shown. Enable hardware acceleration, or open the '
    + 'page in another browser. The panels work without WebGL.');
}

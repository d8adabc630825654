// SPDX-License-Identifier: Apache-2.0
// The panels next to the model. Texts are inserted as text nodes, so that nothing in a scene becomes markup.

function make(tag, options = {}, ...children) {
  const { class: name, ...rest } = options;
  const node = Object.assign(document.createElement(tag), rest);
  if (name) node.className = name;
  node.append(...children);
  return node;
}

const number = (value) => Number(value.toPrecision(6)).toLocaleString('en-US', { maximumSignificantDigits: 6 });

function picture(data) {
  const image = make('img', { class: 'picture', src: `data:${data.picture.type};base64,${data.picture.data}`,
    alt: `${data.name}, rendered`, title: 'Larger' });
  image.addEventListener('click', () => {
    const large = make('div', { id: 'large' }, make('img', { src: image.src, alt: image.alt }));
    const close = (event) => {
      if (event.type === 'keydown' && event.key !== 'Escape') return;
      large.remove();
      removeEventListener('keydown', close);
    };
    large.addEventListener('click', close);
    addEventListener('keydown', close);
    document.body.append(large);
  });
  return [image, make('p', { class: 'note', textContent: data.picture.note })];
}

const SMALL_TREE = 80;

/// Branches of large trees below the second level are created when they are opened.
function branch(tree, id, depth) {
  const node = tree.nodes[id];
  const rule = tree.productions[node.production];
  const line = [make('span', { class: node.children.length ? 'symbol' : 'terminal', textContent: node.text })];
  if (rule) line.push(make('span', { class: 'rule', textContent: rule.name }));
  const title = rule ? `${node.path}, by ${rule.name} in ${rule.where.file}:${rule.where.line}` : node.path;
  if (!node.children.length) return make('li', { class: 'leaf', title }, ...line);
  const below = make('ul');
  const fill = () => {
    if (!below.childElementCount) below.append(...node.children.map((child) => branch(tree, child, depth + 1)));
  };
  const details = make('details', { open: depth < 2 || tree.nodes.length <= SMALL_TREE }, make('summary', { title }, ...line), below);
  if (details.open) fill();
  details.addEventListener('toggle', () => { if (details.open) fill(); });
  return make('li', {}, details);
}
function trees(data) {
  return data.trees.flatMap(({ name, tree }) => [
    make('h2', { textContent: name }),
    make('p', { class: 'note', textContent: `${tree.nodes.length} nodes, ${tree.applied} productions applied` }),
    make('ul', { class: 'tree' }, branch(tree, 0, 0)),
  ]);
}

const METRICS = {
  area: ['Area', 'm\u00b2'], volume: ['Volume', 'm\u00b3'], volume_cells: ['Volume by cells', 'm\u00b3'],
  cf: ['Convex edges (CF)', '%'], cf_area: ['Convex edges by area', '%'],
  vertices: ['Vertices', ''], triangles: ['Triangles', ''], productions: ['Productions', ''],
  components: ['Pieces', ''], genus: ['Genus (handles)', ''],
};
const FAULTS = {
  boundary_edges: 'Open edges', nonmanifold_edges: 'Non-manifold edges',
  misoriented_edges: 'Misoriented edges', self_intersections: 'Self-intersections',
  zero_area_triangles: 'Triangles without area', folded_triangles: 'Folded triangles',
};
const row = (name, text, look = '') =>
  make('tr', {}, make('td', { textContent: name }), make('td', { class: look, textContent: text }));

function metrics(data) {
  const left = { ...data.metrics };
  const rows = [], faults = [];
  for (const [key, [name, unit]] of Object.entries(METRICS)) {
    if (typeof left[key] === 'number') rows.push(row(name, `${number(left[key])} ${unit}`.trim()));
    delete left[key];
  }
  for (const [key, name] of Object.entries(FAULTS)) {
    if (typeof left[key] === 'number') faults.push(row(name, number(left[key]), left[key] ? 'bad' : 'good'));
    delete left[key];
  }
  for (const { center, count } of (left.invalid_places ?? []).slice(0, 5))
    faults.push(row(`at (${center.map(number).join(', ')})`, number(count), 'bad'));
  delete left.invalid_places;
  for (const { kind, center, removed } of (left.small_features ?? []).slice(0, 5))
    faults.push(row(`at (${center.map(number).join(', ')})`, removed ? `${kind}, removed` : kind, removed ? 'good' : 'bad'));
  delete left.small_features;
  const box = left.bounds;
  delete left.bounds;
  if (Array.isArray(box))
    for (const axis of [0, 1, 2])
      rows.push(row(`Along ${'xyz'[axis]}`, `${number(box[0][axis])} to ${number(box[1][axis])} m`));
  for (const [key, value] of Object.entries(left))
    if (value !== null) rows.push(row(key.replaceAll('_', ' '), typeof value === 'number' ? number(value) : JSON.stringify(value)));
  const table = (all) => make('table', {}, make('tbody', {}, ...all));
  return [make('h2', { textContent: data.mesh ? `The whole mesh ‘${data.mesh}’` : 'The whole mesh' }), table(rows), make('h2', { textContent: 'Faults' }), table(faults)];
}

function parameters(data) {
  return data.parameters.map((each) => {
    const top = make('div', { class: 'top' }, make('span', { textContent: each.name }),
      make('span', { class: 'value', textContent: each.value }));
    const out = make('div', { class: 'param' }, top);
    if (each.doc) out.append(make('p', { textContent: each.doc }));
    if (typeof each.share === 'number') {
      const filled = make('i');
      filled.style.width = `${100 * Math.min(1, Math.max(0, each.share))}%`;
      out.append(make('div', { class: 'bar' }, filled));
    }
    if (each.low)
      out.append(make('div', { class: 'ends' }, make('span', { textContent: each.low }), make('span', { textContent: each.high })));
    if (each.value !== each.fallback) out.append(make('p', { textContent: `${each.fallback} without -D` }));
    return out;
  });
}

function recipe(data) {
  const text = make('pre');
  data.recipe.split('\n').forEach((line, i) => {
    if (i) text.append('\n');
    text.append(/^\s*#/.test(line) ? make('span', { class: 'comment', textContent: line }) : line);
  });
  const copy = make('button', { class: 'copy', textContent: 'Copy' });
  copy.addEventListener('click', async () => {
    await navigator.clipboard.writeText(data.recipe);
    copy.textContent = 'Copied';
  });
  return [copy, make('p', { class: 'note', textContent: `Seed ${data.seed}, frame ${data.frame}, Vug ${data.version}` }), text];
}

const PANELS = [
  ['Picture', picture, (data) => data.picture],
  ['Tree', trees, (data) => data.trees.length],
  ['Metrics', metrics, (data) => data.metrics],
  ['Parameters', parameters, (data) => data.parameters.length],
  ['Recipe', recipe, (data) => data.recipe],
];

/// Creates a tab and a page for each panel with data.
export function showPanels(data, tabs, pages) {
  const shown = PANELS.filter(([, , has]) => has(data));
  const all = shown.map(([name, build]) => {
    const id = `page-${name.toLowerCase()}`;
    const page = make('section', { class: 'page', id, hidden: true }, ...build(data));
    page.setAttribute('role', 'tabpanel');
    const tab = make('button', { textContent: name });
    tab.setAttribute('role', 'tab');
    tab.setAttribute('aria-controls', id);
    pages.append(page);
    tabs.append(tab);
    return { tab, page };
  });
  const open = (chosen) => {
    for (const { tab, page } of all) {
      page.hidden = page !== chosen.page;
      tab.setAttribute('aria-selected', page === chosen.page);
    }
    pages.scrollTop = 0;
  };
  for (const each of all) each.tab.addEventListener('click', () => open(each));
  addEventListener('keydown', (event) => { if (all[event.key - 1]) open(all[event.key - 1]); });
  open(all[0]);
}

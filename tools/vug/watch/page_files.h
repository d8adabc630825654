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
<main><img id="picture" alt="The picture of the scene"></main>
<aside>
<h1 id="title"></h1>
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
function show(state) {
  document.title = state.title + ' - vug watch';
  part('title').textContent = state.title;
  part('problems').replaceChildren(...state.problems.map(problem));
  const stale = state.problems.some((each) => each.error);
  document.body.classList.toggle('stale', stale);
  if (state.number !== shown) part('picture').src = 'picture.png?' + state.number;
  shown = state.number;
  if (shown === 0) return;
  const seconds = state.seconds.toFixed(1) + ' s';
  part('status').textContent =
      stale ? 'The picture is that of the last version without errors.'
      : state.complete ? 'Complete after ' + seconds : 'Unfinished after ' + seconds;
  part('work').textContent = state.work;
}

const events = new EventSource('events');
events.onmessage = (event) => show(JSON.parse(event.data));
events.onerror = () => { part('status').textContent = 'vug watch has ended.'; };
)"};

inline constexpr std::array kPageFiles = {kPageHtml, kPageCss, kPageJs};

}  // namespace vug::cli

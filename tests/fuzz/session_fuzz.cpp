// SPDX-License-Identifier: Apache-2.0
// Any session file is rejected as bad input or replayed completely; then its text yields the same
// tree and the same text again, and so does undoing and redoing all edits.
#include "require.h"
#include "target.h"

#include <vug/facade/tree_output.h>
#include <vug/modeller/query.h>
#include <vug/modeller/session.h>
#include <vug/scene/parser.h>

#include <cstdint>

namespace {

using namespace vug;

/// A small style with one of each split that has free numbers, conditions, arguments and inner
/// splits.
modeller::StylePtr style() {
  const std::string text =
      "grammar f: facade {\n axiom Facade\n"
      "Facade -> rows(Row, Part)\n Facade -> mirror(Part, Part)\n Facade -> repeat(x, Part)\n"
      "Part -> mirror(Part)\n Part -> Grid\n Part -> Even\n Part if width > 2m -> repeat(y, Part)\n"
      "Part -> rows(1, Row, 2, columns(Part, wall))\n"
      "Grid -> grid(window, regular: false, identical: false)\n Even -> grid(window, door)\n"
      "Row -> repeat(x, Bay(index), alike: false, even: false)\n"
      "Bay(n) if n < 3 -> window\n Bay(n) -> wall columns(door, shop) rows(wall, wall)\n}\n";
  static const modeller::StylePtr made = [&] {
    Diagnostics diagnostics;
    return modeller::Style::make(scene::parse(text, "fuzz.vug", diagnostics));
  }();
  return made;
}

modeller::Session read(const std::string& text) {
  return modeller::read_session(text, "fuzz.json",
                                [](const auto&, const auto&) { return style(); });
}

/// Whether the text may request very many parts, which is valid but slow: counts of three digits or
/// with an exponent.
bool crowded(const std::string& text) {
  int digits = 0;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    if (digits > 0 && (c == 'e' || c == 'E')) return true;
    digits = digit ? digits + 1 : 0;
    if (digits > 2) return true;
  }
  return false;
}

}  // namespace

VUG_FUZZ_TARGET(session) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (size > 4000 || crowded(text)) return;
  try {
    modeller::Session session = read(text);
    const std::string tree = facade::tree_json(session.current().tree());
    const std::string written = modeller::session_text(session);
    const modeller::Session again = read(written);
    require(facade::tree_json(again.current().tree()) == tree, "a session's text gives its tree");
    require(modeller::session_text(again) == written, "and its text");
    const size_t done = session.history.undo(session.history.done());
    session.history.redo(done);
    require(facade::tree_json(session.current().tree()) == tree,
            "what is undone can be done again");
    for (const int node : session.current().open())
      if (node < 20) modeller::choices(session.current(), node);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input || error.code() == ErrorCode::too_large,
            "errors blame the text");
  }
}

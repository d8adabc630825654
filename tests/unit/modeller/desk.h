// SPDX-License-Identifier: Apache-2.0
// Facades and helpers for tests of the modeller.
#pragma once

#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/facade/tree_output.h>
#include <vug/modeller/edit.h>
#include <vug/scene/parser.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace vug::modeller {

inline StylePtr style_of(const std::string& text) {
  Diagnostics diagnostics;
  scene::Document document = scene::parse(text, "test.vug", diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return Style::make(std::move(document));
}

/// The grammar of the paper.
inline StylePtr ripperda() {
  static const StylePtr made =
      style_of(read_text(std::filesystem::path(VUG_DATA) / "facades" / "ripperda.vug"));
  return made;
}

inline FacadeState blank(double width = 12, double height = 9) {
  return {ripperda(), {.width = width, .height = height}};
}

/// The state after edits given as lines of text.
inline FacadeState after(FacadeState state, const std::vector<std::string>& edits) {
  for (const std::string& each : edits) state = perform_edit(state, parse_edit(each));
  return state;
}

/// "key: message (hint)" of a rejected edit.
inline std::string refusal(const FacadeState& state, const std::string& edit) {
  try {
    perform_edit(state, parse_edit(edit));
  } catch (const RejectedEdit& refused) {
    return refused.key() + ": " + refused.what() +
           (refused.hint().empty() ? "" : " (" + refused.hint() + ")");
  }
  return "";
}

/// All results of a state as text.
inline std::string bytes(const FacadeState& state) { return facade::tree_json(state.tree()); }

/// Rectangles of all elements, sorted from the left, then from the bottom.
inline std::vector<facade::Rect> rects(const FacadeState& state,
                                       const std::string& kind = "window") {
  std::vector<facade::Rect> out;
  for (const facade::ElementInstance& one : facade::element_instances(state.tree()))
    if (state.node(one.node).element->kind() == kind) out.push_back(one.rect);
  std::sort(out.begin(), out.end(), [](const facade::Rect& a, const facade::Rect& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  });
  return out;
}

}  // namespace vug::modeller

// SPDX-License-Identifier: Apache-2.0
// Helpers that derive facades from texts.
#pragma once

#include <gtest/gtest.h>
#include <vug/facade/derive.h>
#include <vug/facade/tree_output.h>
#include <vug/scene/parser.h>

#include <algorithm>
#include <string>

namespace vug::facade {

/// A facade of 12 m x 9 m derived from rules, with all diagnostics as lines "message (hint)".
struct Sample {
  explicit Sample(const std::string& block, uint64_t seed = 0, double width = 12,
                  double height = 9) {
    Diagnostics diagnostics;
    const scene::Document document = scene::parse(block, "test.vug", diagnostics);
    scene::Resolver resolver;
    scene::Evaluator evaluator(document, resolver, diagnostics);
    if (!document.grammars.empty()) {
      const Rules rules = read_rules(document, document.grammars.back(), diagnostics);
      if (!diagnostics.has_errors())
        if (auto made = derive(rules, evaluator,
                               {.width = width, .height = height, .key = RandomKey(seed)}))
          tree = made->tree;
    }
    for (const Diagnostic& one : diagnostics.all()) {
      said += one.message + (one.hint.empty() ? "" : " (" + one.hint + ")") + '\n';
      where = one.where;
    }
  }

  /// The rectangles of all elements of that kind, in the order of element_instances(); at least
  /// one, so that a test of a facade with errors fails instead of crashing.
  std::vector<Rect> rects(const std::string& kind) const {
    std::vector<Rect> out;
    for (const ElementInstance& one : element_instances(tree))
      if (tree.nodes[static_cast<size_t>(one.node)].element->kind() == kind)
        out.push_back(one.rect);
    EXPECT_FALSE(out.empty()) << "no " << kind << ": " << said;
    if (out.empty()) out.emplace_back();
    return out;
  }

  Tree tree;
  std::string said;
  SourceLocation where;  ///< Location of the last diagnostic.
};

inline Sample facade_of(const std::string& rules, uint64_t seed = 0, double width = 12,
                        double height = 9) {
  return Sample("grammar f: facade {\n" + rules + "\n}\n", seed, width, height);
}

inline void expect_rect(const Rect& r, double x, double y, double width, double height) {
  EXPECT_NEAR(r.x, x, 1e-9);
  EXPECT_NEAR(r.y, y, 1e-9);
  EXPECT_NEAR(r.width, width, 1e-9);
  EXPECT_NEAR(r.height, height, 1e-9);
}

}  // namespace vug::facade

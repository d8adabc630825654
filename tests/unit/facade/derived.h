// Facades of texts, for tests.
#pragma once

#include <gtest/gtest.h>
#include <vug/facade/derive.h>
#include <vug/facade/tree_output.h>
#include <vug/scene/parser.h>

#include <algorithm>
#include <string>

namespace vug::facade {

/// A facade of rules, 12 m x 9 m, and all that was said of them: "message (hint)" in lines.
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

  /// All places of elements of that kind, in the order of element_instances(); at least one, so
  /// that a test of a facade with faults fails instead of crashing.
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
  SourceLocation where;  ///< Of the last thing said.
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

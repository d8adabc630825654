// SPDX-License-Identifier: Apache-2.0
// Any block of a facade is rejected with error messages or derived twice to the same tree, whose
// parts lie within their parents; it is also derived by a plan that leaves all choices open.
#include "require.h"
#include "target.h"

#include <vug/facade/derive.h>
#include <vug/facade/tree_output.h>
#include <vug/scene/parser.h>

#include <cmath>
#include <cstdint>

namespace {

using namespace vug;

void check(const facade::Tree& tree) {
  for (const facade::Node& node : tree.nodes) {
    require(std::isfinite(node.rect.x + node.rect.y), "places are numbers");
    require(node.rect.width >= 0 && node.rect.height >= 0, "sizes are not below 0");
    if (node.parent < 0) continue;
    const facade::Rect& over = tree.nodes[static_cast<size_t>(node.parent)].rect;
    const double slack = 1e-6 * (over.width + over.height);
    require(node.rect.x >= over.x - slack && node.rect.right() <= over.right() + slack &&
                node.rect.y >= over.y - slack && node.rect.top() <= over.top() + slack,
            "parts lie within their parents");
  }
  facade::theta(tree);
}

}  // namespace

VUG_FUZZ_TARGET(facade) {
  const std::string text =
      "grammar g: facade {\n" + std::string(reinterpret_cast<const char*>(data), size) + "\n}\n";
  scene::ParseOptions parsing;
  parsing.read = [](const std::filesystem::path&) -> std::optional<std::string> {
    return std::nullopt;
  };
  Diagnostics diagnostics;
  const scene::Document document = scene::parse(text, "fuzz.vug", diagnostics, parsing);
  scene::Resolver resolver;
  scene::Evaluator evaluator(document, resolver, diagnostics);
  for (const scene::Grammar& grammar : document.grammars) {
    if (grammar.kind != "facade" || grammar.broken) continue;
    const facade::Rules rules = facade::read_rules(document, grammar, diagnostics);
    if (diagnostics.has_errors()) return;
    facade::DeriveOptions options;
    options.limits = {500, 3000};
    try {
      const auto made = facade::derive(rules, evaluator, options);
      if (!made) return;
      check(made->tree);
      const auto again = facade::derive(rules, evaluator, options);
      require(again && facade::theta(again->tree) == facade::theta(made->tree),
              "a facade is the same each time");
      const auto open = facade::derive(rules, evaluator, options, facade::PlanOptions{{}, 0.01});
      if (open) check(open->derived.tree);
    } catch (const Error& error) {
      require(error.code() == ErrorCode::bad_input || error.code() == ErrorCode::too_large,
              "errors blame the text");
    }
  }
}

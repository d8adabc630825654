// SPDX-License-Identifier: Apache-2.0
// For any bytes: parses, reports errors and evaluates expressions without objects. Formatting a
// text without errors must keep its meaning and be idempotent, and its ranges must nest. The texts
// can include the file kit.vug, also as a module.
#include "../unit/scene/extents.h"
#include "require.h"
#include "target.h"

#include <vug/scene/check.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/format.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>

#include <cstdint>

namespace {

using namespace vug;
using namespace vug::scene;

constexpr const char* kKit = R"(param edge = 2cm in 0cm..9cm "of slabs"
let _size = 3 * edge
let part = (_size, 1m, 1m)
def slab(at, size = _size, turn = 0deg) "A slab." = mix(at, part, sin(turn)) * _share(r / 1m)
    where r = size..2 * size
def _share(of) = of + _size / 1m
)";

ParseOptions with_kit() {
  ParseOptions options;
  options.read = [](const std::filesystem::path& path) -> std::optional<std::string> {
    if (path.filename() != "kit.vug") return std::nullopt;
    return kKit;
  };
  return options;
}

/// Evaluates what does not need objects: values, entries, loops and counts.
void evaluate(const Document& document, Evaluator& evaluator) {
  evaluator.check_all();
  for (const Declaration& made : document.declarations) {
    if (made.loop) evaluator.eval(*made.loop, evaluator.key(made));
    if (made.value) evaluator.eval(*made.value, evaluator.key(made));
    for (const Entry& entry : made.entries) evaluator.eval(entry, evaluator.key(made));
  }
  for (const Grammar& grammar : document.grammars)
    for (const Rule& rule : grammar.rules) {
      Locals locals(rule.locals, evaluator.root());
      const Scope scope{{}, nullptr, &locals};
      for (const Item& item : rule.items)
        if (item.count) evaluator.count(*item.count, evaluator.root(), &scope);
    }
}

std::string formatted_dump(const std::string& text, const ParseOptions& options) {
  Diagnostics diagnostics;
  const Document document = parse(text, "fuzz.vug", diagnostics, options);
  require(!diagnostics.has_errors(), "a formatted text parses");
  return dump(document);
}

}  // namespace

VUG_FUZZ_TARGET(scene_parser) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const ParseOptions options = with_kit();
  Diagnostics diagnostics;
  const Document document = parse(text, "fuzz.vug", diagnostics, options);
  const std::string formatted = format(text);
  if (!diagnostics.has_errors()) {
    require(formatted_dump(formatted, options) == dump(document), "format keeps the meaning");
    require(format(formatted) == formatted, "format settles after one pass");
    check_unused_names(document, diagnostics);
    const auto nests = [](const SourceLocation& parent, const SourceLocation& child) {
      require(parent.contains(child), "the ranges of a document nest");
    };
    ExtentVisitor(nests, [](const Expr&) {}).document(document);
  }
  Resolver resolver;
  Evaluator evaluator(document, resolver, diagnostics);
  evaluate(document, evaluator);
  report(diagnostics, evaluator.sources());
}

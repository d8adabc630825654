// SPDX-License-Identifier: Apache-2.0
// For any bytes: parses, reports errors and evaluates expressions without objects. Formatting a
// text without errors must keep its meaning and be idempotent, and its ranges must nest.
#include "../unit/scene/extents.h"
#include "require.h"

#include <vug/scene/check.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/format.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>

#include <cstdint>

namespace {

using namespace vug;
using namespace vug::scene;

std::string formatted_dump(const std::string& text, const ParseOptions& options) {
  Diagnostics diagnostics;
  const Document document = parse(text, "fuzz.vug", diagnostics, options);
  require(!diagnostics.has_errors(), "a formatted text parses");
  return dump(document);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  ParseOptions options;
  options.read = [](const std::filesystem::path&) -> std::optional<std::string> {
    return std::nullopt;
  };
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
  evaluator.check_all();
  for (const Declaration& made : document.declarations) {
    if (made.value) evaluator.eval(*made.value, evaluator.key(made));
    for (const Entry& entry : made.entries) evaluator.eval(entry, evaluator.key(made));
  }
  for (const Grammar& grammar : document.grammars)
    for (const Rule& rule : grammar.rules)
      for (const Item& item : rule.items)
        if (item.count) evaluator.count(*item.count, evaluator.root());
  report(diagnostics, evaluator.sources());
  return 0;
}

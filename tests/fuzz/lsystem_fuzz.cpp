// SPDX-License-Identifier: Apache-2.0
// For any block of an L-system: it is rejected with error messages, or it is derived for a few
// steps with matching brackets, and formatting keeps its meaning and is idempotent.
#include "require.h"
#include "target.h"

#include <vug/lsystem/compile.h>
#include <vug/lsystem/derive.h>
#include <vug/scene/format.h>
#include <vug/scene/lsystem_document.h>
#include <vug/scene/parser.h>

#include <algorithm>
#include <cstdint>

namespace {

using namespace vug;

scene::Document parse(const std::string& text, Diagnostics& diagnostics) {
  scene::ParseOptions options;
  options.read = [](const std::filesystem::path&) -> std::optional<std::string> {
    return std::nullopt;
  };
  return scene::parse(text, "fuzz.vug", diagnostics, options);
}

void check_word(const lsystem::System& system, const lsystem::Word& word) {
  int depth = 0;
  for (size_t i = 0; i < word.size(); ++i) {
    depth += word.symbol(i) == system.open ? 1 : word.symbol(i) == system.close ? -1 : 0;
    require(depth >= 0, "branches that end have begun");
    require(word.parameters(i).size() == system.alphabet.parameters(word.symbol(i)),
            "modules have their parameters");
  }
  require(depth == 0, "branches end");
  lsystem::to_string(word, system.alphabet);
}

void grow(lsystem::System system) {
  system.limit = std::min<int64_t>(system.limit, 2000);
  system.steps = std::min(system.steps, 6);
  system.time = std::min(system.time, 6.0);
  try {
    const lsystem::Derivation word = lsystem::derive(system);
    require(word == lsystem::derive(system), "a word is the same each time");
    check_word(system, word.word);
    check_word(system, lsystem::interpret(system, word));
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input || error.code() == ErrorCode::too_large,
            "errors blame the text");
  }
}

}  // namespace

VUG_FUZZ_TARGET(lsystem) {
  const std::string text =
      "grammar g: lsystem {\n" + std::string(reinterpret_cast<const char*>(data), size) + "\n}\n";
  Diagnostics diagnostics;
  const scene::Document document = parse(text, diagnostics);
  const std::string formatted = scene::format(text);
  if (diagnostics.has_errors()) return;
  Diagnostics again;
  require(dump(parse(formatted, again)) == dump(document), "format keeps the meaning");
  require(scene::format(formatted) == formatted, "format settles after one pass");
  scene::Resolver resolver;
  scene::Evaluator evaluator(document, resolver, diagnostics);
  for (const scene::Grammar& grammar : document.grammars)
    if (grammar.lsystem && !grammar.broken)
      if (const auto system = lsystem::compile(
              grammar, evaluator, [](const auto&, const auto&) { return lsystem::SystemPtr(); }))
        grow(*system);
}

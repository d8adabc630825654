// SPDX-License-Identifier: Apache-2.0
// Helpers that compile L-systems from texts.
#pragma once

#include <vug/lsystem/compile.h>
#include <vug/lsystem/derive.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>

#include <gtest/gtest.h>

namespace vug::lsystem {

/// The system compiled from a text, and the report of its errors.
struct Compiled {
  SystemPtr system;
  Diagnostics diagnostics;
  std::string report;
};

/// `text` is a scene with at least one L-system; the last one is compiled, and modules may refer to
/// the others.
inline Compiled compile_text(const std::string& text,
                             const std::vector<scene::Override>& overrides = {}) {
  Compiled out;
  const scene::Document document = scene::parse(text, "test.vug", out.diagnostics);
  scene::Resolver resolver;
  scene::Evaluator evaluator(document, resolver, out.diagnostics, {overrides, {}, 1});
  std::map<std::string, SystemPtr> made;
  const FindSystem find = [&](const std::string& name, const SourceLocation&) {
    const auto known = made.find(name);
    return known == made.end() ? SystemPtr() : known->second;
  };
  for (const scene::Grammar& grammar : document.grammars)
    if (!grammar.broken) made[grammar.name] = out.system = compile(grammar, evaluator, find);
  out.report = scene::report(out.diagnostics, document.sources);
  return out;
}

/// Compiles the rules of a block named `g`; the test fails if they have errors.
inline SystemPtr system_of(const std::string& rules) {
  const Compiled compiled = compile_text("grammar g: lsystem {\n" + rules + "\n}\n");
  EXPECT_TRUE(compiled.system) << compiled.report;
  return compiled.system;
}

/// The word after the given number of steps.
inline std::string after(const System& system, int steps) {
  DeriveOptions options;
  options.steps = steps;
  return to_string(derive(system, options).word, system.alphabet);
}

inline std::string drawn(const System& system, int steps) {
  DeriveOptions options;
  options.steps = steps;
  return to_string(interpret(system, derive(system, options)), system.alphabet);
}

}  // namespace vug::lsystem

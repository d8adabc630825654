// SPDX-License-Identifier: Apache-2.0
// A resolver that knows the names of a few shapes only.
#pragma once

#include <vug/scene/evaluator.h>
#include <vug/scene/parser.h>

#include <algorithm>

namespace vug::scene {

class FakeResolver : public Resolver {
 public:
  std::optional<Value> call(const std::string& name, const Arguments&, const SourceLocation&,
                            const CallContext& context, Diagnostics&) override {
    const auto calls = known_calls();
    if (std::find(calls.begin(), calls.end(), name) == calls.end()) return std::nullopt;
    return Object{"field", name + "#" + std::to_string(context.key.state())};
  }
  std::optional<Value> binary(char op, const Value& a, const Value& b, const SourceLocation&,
                              Diagnostics&) override {
    const bool fields = a.object<std::string>() && b.object<std::string>();
    if (!fields || op == '*' || op == '/' || op == '^') return std::nullopt;
    return Object{"field", *a.object<std::string>() + op + *b.object<std::string>()};
  }
  std::vector<std::string> known_calls() const override { return {"sphere", "box", "torus"}; }
};

/// Evaluates all expressions of a document except those of grammars.
inline void evaluate_all(Evaluator& evaluator, const Document& document) {
  evaluator.check_all();
  for (const Declaration& made : document.declarations) {
    const RandomKey key = evaluator.key(made);
    if (made.value) evaluator.eval(*made.value, key);
    for (const Entry& entry : made.entries) evaluator.eval(entry, key);
  }
  evaluator.check_uncalled();
}

/// The value of `let x` in a text, as text; errors as "! message".
inline std::string value_of(const std::string& text, EvaluatorOptions options = {}) {
  Diagnostics diagnostics;
  const Document document = parse(text, "t.vug", diagnostics);
  FakeResolver resolver;
  Evaluator evaluator(document, resolver, diagnostics, std::move(options));
  std::string out;
  if (const Let* x = document.find_let("x"))
    out = to_string(evaluator.eval(*x->value, evaluator.root()));
  for (const Diagnostic& one : diagnostics.all()) out += "! " + one.message;
  return out;
}

inline std::string x(const std::string& expression) { return value_of("let x = " + expression); }

}  // namespace vug::scene

// SPDX-License-Identifier: Apache-2.0
// A resolver that knows the names of a few shapes only.
#pragma once

#include <vug/scene/evaluator.h>

#include <algorithm>

namespace vug::scene {

class FakeResolver : public Resolver {
 public:
  std::optional<Value> call(const std::string& name, const Arguments&, const SourceLocation&,
                            RandomKey key, Diagnostics&) override {
    const auto calls = known_calls();
    if (std::find(calls.begin(), calls.end(), name) == calls.end()) return std::nullopt;
    return Object{"field", name + "#" + std::to_string(key.state())};
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
}

}  // namespace vug::scene

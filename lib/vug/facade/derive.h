// Deriving a facade: rules are chosen as in every grammar, splits hand the rectangles on.
#pragma once

#include <vug/facade/rules.h>
#include <vug/facade/tree.h>
#include <vug/grammar/derive.h>
#include <vug/scene/evaluator.h>

#include <optional>

namespace vug::facade {

struct DeriveOptions {
  double width = 12;  ///< Metres.
  double height = 9;
  grammar::Limits limits{100'000, 1'000'000};
  RandomKey key{0};
};

struct Derived {
  grammar::Tree derivation;  ///< With the rules that were chosen, for traces.
  Tree tree;
};

/// Guards, weights, sizes and arguments are evaluated as expressions of the evaluator's document,
/// in which `width` and `height` are the scope's, `index` and `total` say which of how many places
/// of its split a symbol has. Faults go to the evaluator's diagnostics, and then nothing is
/// derived; symbols that no rule applies to are warnings. Error(too_large) beyond the limits.
std::optional<Derived> derive(const Rules& rules, scene::Evaluator& evaluator,
                              const DeriveOptions& options);

}  // namespace vug::facade

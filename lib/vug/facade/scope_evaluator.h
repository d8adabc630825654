// SPDX-License-Identifier: Apache-2.0
// Internal to facade/: evaluation of a rule's expressions in a scope: splits with their cells, and
// elements with their arguments.
#pragma once

#include <vug/facade/derive.h>
#include <vug/facade/scope.h>
#include <vug/scene/evaluator.h>

#include <memory>
#include <vector>

namespace vug::facade {

/// Thrown out of a derivation after an error was added to the diagnostics.
struct AlreadyReported {};

/// A split evaluated in one scope: its cells and its arguments by operand.
struct EvaluatedSplit {
  std::shared_ptr<const Layout> layout;
  std::vector<Value> values;
  std::vector<FreeNumber> free;  ///< The requested free numbers.
};

class ScopeEvaluator {
 public:
  explicit ScopeEvaluator(scene::Evaluator& evaluator) : evaluator_(evaluator) {}

  /// Evaluates the split in the scope, whose names are `known`. Without a plan its free numbers are
  /// drawn at random.
  EvaluatedSplit place(const Item& split, const Scope& scope, const scene::Scope& known,
                       const PlanOptions* planning, const std::string& prefix);
  /// An element of a kind, or the element `value` of a name (empty: not evaluated yet).
  ElementPtr element(const Item& item, Value value, RandomKey key, const scene::Scope& known);
  /// Throws AlreadyReported after an error.
  Value eval(const scene::Expr& expr, RandomKey key, const scene::Scope& scope);
  bool fail(const SourceLocation& where, const std::string& message);

 private:
  Value argument(const Item& split, size_t i, RandomKey key, const scene::Scope& known,
                 Value& named);
  SplitPtr split(const Item& item, RandomKey key, const scene::Scope& known,
                 std::vector<Value>& values);

  scene::Evaluator& evaluator_;
};

std::string metres(double value);
/// "12 x 4.5 m"
std::string size_text(const Rect& r);

}  // namespace vug::facade

// Inside facade/ only: what expressions of a rule come to in a scope: splits with their places,
// elements with their measures.
#pragma once

#include <vug/facade/derive.h>
#include <vug/facade/scope.h>
#include <vug/scene/evaluator.h>

#include <memory>
#include <vector>

namespace vug::facade {

/// Thrown out of a derivation whose text is at fault; the diagnostics already say why.
struct AlreadyReported {};

/// What a split comes to in one scope: its places, and its arguments by operand.
struct EvaluatedSplit {
  std::shared_ptr<const Layout> layout;
  std::vector<Value> values;
  std::vector<FreeNumber> free;  ///< What it asked for.
};

class ScopeEvaluator {
 public:
  explicit ScopeEvaluator(scene::Evaluator& evaluator) : evaluator_(evaluator) {}

  /// The split in the scope, whose names are `known`. Without a plan its free numbers are drawn.
  EvaluatedSplit place(const Item& split, const Scope& scope, const scene::Scope& known,
                       const PlanOptions* planning, const std::string& prefix);
  /// An element of a kind, or `value`, which a name stands for; empty: not looked up yet.
  ElementPtr element(const Item& item, Value value, RandomKey key, const scene::Scope& known);
  /// Throws AlreadyReported instead of giving nothing.
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

// SPDX-License-Identifier: Apache-2.0
// The space in which the numbers of a text are measured: that of the scene, moved by the deformers
// around them.
#pragma once

#include <vug/base/transform.h>
#include <vug/language/expectation.h>
#include <vug/language/statement_walk.h>
#include <vug/language/workspace.h>
#include <vug/scene/evaluator.h>

#include <optional>
#include <string>

namespace vug::language {

/// Whether an expression contains a range or a `pick`.
bool draws_at_random(const scene::Expr& expr);

/// Values of expressions that contain neither objects nor random draws.
class PlainEvaluator {
 public:
  explicit PlainEvaluator(const Analysis& analysis)
      : evaluator_(analysis.document, without_objects_, ignored_) {}

  std::optional<double> number(const scene::Expr& expr);
  std::optional<Vec3d> vector(const scene::Expr& expr);
  /// A default of a schema, such as "(0, 0, 5m)".
  std::optional<Vec3d> vector(const std::string& text);

 private:
  Value value(const scene::Expr& expr);

  scene::Resolver without_objects_;
  Diagnostics ignored_;
  scene::Evaluator evaluator_;
};

/// The kind that a call means; nothing for functions of the text and for unknown names.
std::optional<CallMeaning> kind_of_call(const scene::Expr& call, const scene::Document& document,
                                        const std::string& expected);

/// The operand for a parameter of a call; null if it is not given.
const scene::Expr* operand_for(const scene::Expr& call, const KindInfo& info,
                               const std::string& param);

/// A map from the space of a literal to the scene, or the reason why it is unknown.
struct LiteralFrame {
  std::optional<Transform> place;
  std::string reason;
};

/// The frame of an expression with these expressions around it in a statement. A let has that of
/// its first use.
LiteralFrame frame_of(const Analysis& analysis, PlainEvaluator& values, const Statement& statement,
                      const EnclosingChain& chain);

}  // namespace vug::language

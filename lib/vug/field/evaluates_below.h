// SPDX-License-Identifier: Apache-2.0
// Nodes that need less work if only values below a limit matter.
#pragma once

#include <vug/field/node.h>

namespace vug::field {

/// Where a value is not below its limit, `out` is any number that is not below it either, with any
/// derivatives; elsewhere it is the same as that of Node::eval.
class EvaluatesBelow {
 public:
  virtual ~EvaluatesBelow() = default;
  virtual void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                          Scratch& scratch) const = 0;
  virtual void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                          Scratch& scratch) const = 0;
  /// As Node::restrict_to, for values below a limit: the smaller expression has the same values
  /// there within the ball, and elsewhere values that are not below it. If no value is below the
  /// limit, the range begins above it.
  virtual Restriction restrict_below(const Ball& ball, double limit) const = 0;

 protected:
  EvaluatesBelow() = default;
  EvaluatesBelow(const EvaluatesBelow&) = default;
  EvaluatesBelow& operator=(const EvaluatesBelow&) = default;
};

/// The same of any node.
template <class T>
void evaluate_below(const Node& node, const Point<Pack>* points, const Pack* limits, int count,
                    T* out, Scratch& scratch) {
  if (const auto* below = dynamic_cast<const EvaluatesBelow*>(&node))
    below->eval_below(points, limits, count, out, scratch);
  else
    node.eval(points, count, out, scratch);
}
inline Restriction restrict_below(const Node& node, const Ball& ball, double limit) {
  const auto* below = dynamic_cast<const EvaluatesBelow*>(&node);
  return below ? below->restrict_below(ball, limit) : node.restrict_to(ball);
}

/// A limit above which values do not change a blend of the given radius with `value`. It is a
/// little larger, so that equal values are below it.
inline Pack limit_for(const Pack& value, double radius) {
  return value + Pack(radius * (1 + 1e-5)) + abs(value) * Pack(1e-5) + Pack(1e-20);
}

}  // namespace vug::field

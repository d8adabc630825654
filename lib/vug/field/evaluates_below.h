// SPDX-License-Identifier: Apache-2.0
// Nodes that need less work if only values below a limit matter.
#pragma once

#include <vug/field/interface_of.h>

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
  /// Whether limits save work; if not, the node is evaluated as others.
  virtual bool skips() const { return true; }
  /// The child of a node that has one, and only passes limits on to it; null for others.
  virtual const Node* only_child() const { return nullptr; }

 protected:
  EvaluatesBelow() = default;
  EvaluatesBelow(const EvaluatesBelow&) = default;
  EvaluatesBelow& operator=(const EvaluatesBelow&) = default;
};

/// Nodes that pass limits on to their child. Derived has
///   template <class T> void fill_below(const Point<Pack>* points, const Pack* limits, int count,
///                                      T* out, Scratch&) const;
template <class Derived>
class LimitModes : public EvaluatesBelow {
 public:
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                  Scratch& scratch) const final {
    self().fill_below(points, limits, count, out, scratch);
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                  Scratch& scratch) const final {
    self().fill_below(points, limits, count, out, scratch);
  }
  Restriction restrict_below(const Ball& ball, double) const final {
    return self().restrict_to(ball);
  }

 private:
  const Derived& self() const { return static_cast<const Derived&>(*this); }
};

/// The node, if limits save work; otherwise null.
inline const EvaluatesBelow* evaluates_below(const Node& node) {
  const auto* below = interface_of<EvaluatesBelow>(node);
  return below && below->skips() ? below : nullptr;
}

/// The same of any node.
template <class T>
void evaluate_below(const Node& node, const Point<Pack>* points, const Pack* limits, int count,
                    T* out, Scratch& scratch) {
  if (const EvaluatesBelow* below = evaluates_below(node))
    below->eval_below(points, limits, count, out, scratch);
  else
    node.eval(points, count, out, scratch);
}
inline Restriction restrict_below(const Node& node, const Ball& ball, double limit) {
  const EvaluatesBelow* below = evaluates_below(node);
  return below ? below->restrict_below(ball, limit) : node.restrict_to(ball);
}

/// A limit above which values do not change a blend of the given radius with `value`. It is a
/// little larger, so that equal values are below it.
inline Pack limit_for(const Pack& value, double radius) {
  return value + Pack(radius * (1 + 1e-5)) + abs(value) * Pack(1e-5) + Pack(1e-20);
}

}  // namespace vug::field

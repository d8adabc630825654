// SPDX-License-Identifier: Apache-2.0
// The handle to a field expression: a cheap, immutable value that can be shared between threads.
#pragma once

#include <vug/field/node.h>

namespace vug::field {

struct Gradient {
  double value = 0;
  Vec3d gradient{0, 0, 0};
};

/// A function of space in metres, negative inside. Never null.
class Field {
 public:
  /// The empty field, which has no solid.
  Field();
  explicit Field(NodePtr node) : node_(std::move(node)) {}

  double value(const Vec3d& p) const { return node_->eval(point(p)); }
  /// Value and gradient by forward differentiation (exact up to rounding; one-sided at creases).
  Gradient gradient(const Vec3d& p) const;
  /// Bounds of the value over a box: interval arithmetic intersected with the Lipschitz bound.
  Interval interval(const Box3d& box) const;

  /// Batches of 8 * count points; see Node.
  void values(const Point<Pack>* points, int count, Pack* out, Scratch& scratch) const {
    node_->eval(points, count, out, scratch);
  }
  void gradients(const Point<Pack>* points, int count, Dual<Pack>* out, Scratch& scratch) const {
    node_->eval(points, count, out, scratch);
  }

  struct RestrictedField;
  /// Restricts the field to a ball: operands that cannot matter there are removed.
  RestrictedField restricted(const Ball& ball) const;
  /// Restricts the field to a ball, in which only values with |value| <= limit matter; see
  /// near_surface.h.
  RestrictedField restricted_near(const Ball& ball, double limit) const;

  double lipschitz() const { return node_->traits().lipschitz; }
  Exactness exactness() const { return node_->traits().exactness; }
  const Box3d& bounds() const { return node_->traits().bounds; }
  const NodePtr& node() const { return node_; }
  /// See Node::digest.
  Digest digest() const;

 private:
  NodePtr node_;
};

struct Field::RestrictedField {
  Field field;
  Interval range;
};

/// The expression with one indented line per node, for people.
std::string to_string(const Field& field);

/// Number of nodes of the expression; shared nodes count once.
size_t node_count(const Field& field);

/// The cost of one evaluation.
struct EvaluationCost {
  double visits =
      1;  ///< Visited nodes; shared nodes count once per use. May exceed the range of integers.
  size_t depth = 1;  ///< Nodes on the longest path.
};
EvaluationCost extent(const Field& field);

}  // namespace vug::field

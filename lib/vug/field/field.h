// The handle to a field expression: a cheap value, immutable, safe to share.
#pragma once

#include <vug/field/node.h>

namespace vug::field {

struct Gradient {
  double value = 0;
  Vec3d gradient{0, 0, 0};
};

/// A function of space, metres in and metres out, negative inside. Never null.
class Field {
 public:
  /// The empty field: no solid anywhere.
  Field();
  explicit Field(NodePtr node) : node_(std::move(node)) {}

  double value(const Vec3d& p) const { return node_->eval(point(p)); }
  /// Value and gradient by forward differentiation (exact up to rounding; at creases one side's).
  Gradient gradient(const Vec3d& p) const;
  /// Bounds of the value over a box: natural interval arithmetic met with the Lipschitz bound.
  Interval interval(const Box3d& box) const;

  /// Batches of 8 * count points; see Node.
  void values(const Point<Pack>* points, int count, Pack* out, Scratch& scratch) const {
    node_->eval(points, count, out, scratch);
  }
  void gradients(const Point<Pack>* points, int count, Dual<Pack>* out, Scratch& scratch) const {
    node_->eval(points, count, out, scratch);
  }

  struct RestrictedField;
  /// The same field, seen inside a ball only: smaller where operands cannot matter there.
  RestrictedField restricted(const Ball& ball) const;

  double lipschitz() const { return node_->traits().lipschitz; }
  Exactness exactness() const { return node_->traits().exactness; }
  const Box3d& bounds() const { return node_->traits().bounds; }
  const NodePtr& node() const { return node_; }

 private:
  NodePtr node_;
};

struct Field::RestrictedField {
  Field field;
  Interval range;
};

/// The expression as one indented line a node: for people.
std::string to_string(const Field& field);

/// Nodes of the expression, shared ones counted once.
size_t node_count(const Field& field);

/// What one evaluation costs.
struct EvaluationCost {
  double visits = 1;  ///< Nodes, shared ones once for each place: too many for an integer at times.
  size_t depth = 1;   ///< Nodes on the longest way down.
};
EvaluationCost extent(const Field& field);

}  // namespace vug::field

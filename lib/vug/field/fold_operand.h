// SPDX-License-Identifier: Apache-2.0
// The operands of unions, intersections and differences, with bounds of their values that need no
// evaluation.
#pragma once

#include <vug/field/evaluates_below.h>
#include <vug/field/translated.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::field {

/// Bounds of an operand's values that follow from its box without an evaluation: outside the box
/// the values grow with the distance from it, and inside a depth limits them. Restrictions of large
/// folds to large balls use these bounds alone.
struct Reach {
  Box3d box;
  double growth = 0;  // 0: no information from the box.
  double depth = 0;   // Values inside are above -depth.
  double radius = 0;  // Radius of a ball around the box.

  Reach() = default;
  Reach(const Traits& traits, double sign) : box(traits.bounds) {
    if (sign < 0 || !is_finite(box)) return;
    const Vec3d size = box.size();
    growth = traits.growth_rate();
    depth = 0.5 * traits.lipschitz * std::min({size.x, size.y, size.z});
    radius = 0.5 * size.length();
  }
  /// The minimum of the values within `radius` of c.
  double least(const Ball& ball) const { return least(ball, distance(ball.centre)); }
  /// As above, if the distance of the centre from the box is known.
  double least(const Ball& ball, double distance) const {
    if (growth <= 0) return -kInfinity;
    const double away = distance - ball.radius;
    return away > 0 ? growth * away * (1 - 1e-6) - 1e-6 * ball.centre.length() : -depth * 1.001;
  }
  /// Whether it implies the bounds of another one.
  bool is_within(const Reach& other) const {
    return growth > 0 && growth >= other.growth && depth <= other.depth &&
           (other.growth <= 0 || (other.box.intersects(box.min) && other.box.intersects(box.max)));
  }
  double distance(const Vec3d& c) const {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = std::max({box.min[axis] - c[axis], c[axis] - box.max[axis], 0.0});
      squared += d * d;
    }
    return std::sqrt(squared);
  }
};

struct Operand {
  Operand(NodePtr n, double s) : node(std::move(n)), sign(s), reach(node->traits(), sign) {}
  Operand(NodePtr smaller, const Operand& whole)  // Bounds of the whole also hold for a part.
      : node(std::move(smaller)), sign(whole.sign), reach(node->traits(), sign) {
    if (reach.growth <= 0) reach = whole.reach;
  }
  Operand translated(const Vec3d& by) const {
    Operand out(field::translated(node, by), sign);
    Reach whole = reach;
    if (!reach.box.isEmpty()) whole.box = {reach.box.min + by, reach.box.max + by};
    // A deferred node, whose bounds were promised before it was computed, becomes what it is.
    if (!out.reach.is_within(whole)) out.reach = whole;
    return out;
  }
  NodePtr node;
  double sign;  // The fold uses sign * node.
  Reach reach;
  const EvaluatesBelow* below = sign > 0 ? evaluates_below(*node) : nullptr;
  void add_to(Digester& digester) const { digester(node, sign); }
};

}  // namespace vug::field

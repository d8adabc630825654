// SPDX-License-Identifier: Apache-2.0
// Inspection of expressions without their evaluation.
#pragma once

#include <vug/field/field.h>

#include <vector>

namespace vug::field {

/// Bounds of the value at a point. Deferred fields are not computed; all others are nearly exact.
inline Interval bounds_at(const Field& field, const Vec3d& p) {
  return field.node()->eval(region({p, p}));
}

/// The operands of a union, an intersection or a difference: those whose solid remains, and those
/// that are removed. Both are empty for other nodes.
struct Operands {
  std::vector<NodePtr> kept, removed;
};
Operands operands_of(const Node& node);

/// The field below a displacement; null for other nodes.
NodePtr undisplaced(const Node& node);

}  // namespace vug::field

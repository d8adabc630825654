// SPDX-License-Identifier: Apache-2.0
// Parts of a solid that are thinner than a voxel, so that a level set contains them only if lattice
// points happen to lie inside.
#pragma once

#include <vug/field/field.h>

#include <optional>
#include <vector>

namespace vug::field {

/// An operand of the unions of an expression.
struct ThinPart {
  NodePtr node;
  Vec3d at;              ///< A point at its greatest depth, in the space of the expression, metres.
  double thickness = 0;  ///< Diameter of the largest ball inside it, metres.
  std::optional<double> share{};  ///< For passages: the share of their length that is thin.
};

/// The operands whose thickness is below `thickness` metres, by the order of the expression. Listed
/// are operands whose values are distances, and shells of these, each node once. Unions,
/// differences and affine maps are divided into operands. What is subtracted, and operands of other
/// nodes, are searched for passages only, whose air must be as thick as a voxel.
std::vector<ThinPart> thin_parts(const Field& field, double thickness);

}  // namespace vug::field

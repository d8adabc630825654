// SPDX-License-Identifier: Apache-2.0
// The materials of a field: the interface of the nodes that decide on them, and their evaluation.
#pragma once

#include <vug/field/field.h>
#include <vug/field/material_mean.h>
#include <vug/field/material_mix.h>

#include <optional>
#include <vector>

namespace vug::field {

/// The value of a field in metres and its materials at a point.
struct MaterialSample {
  double value = 0;
  MaterialMix mix;
};

/// The skin that a solid leaves on the rock from which it is cut.
struct Coat {
  MaterialMix mix;
  double share = 0;  ///< From 0 (bare rock) to 1 (only the coat).
};

/// An interface of nodes whose materials are not simply those of their first child at the same
/// point. Evaluations of distances do not use it.
class MaterialSource {
 public:
  virtual ~MaterialSource() = default;
  virtual MaterialSample sample_materials(const Vec3d& p) const = 0;
  /// The coat at a point near the surface of this node.
  virtual Coat coat(const Vec3d&) const { return {}; }
  /// The materials that this node assigns itself.
  virtual std::vector<RockMaterialPtr> assigned() const { return {}; }
  /// See field::material_mean.
  virtual std::optional<Field> material_mean(const MaterialNumber& number) const = 0;
  /// The nodes from which it takes other materials.
  virtual std::vector<NodePtr> material_operands() const = 0;
};

/// Value and materials of a node at a point. A node that is not a MaterialSource has those of its
/// first child at the same point; a node without children has none.
MaterialSample sample_materials(const Node& node, const Vec3d& p);
/// The mean hardness of the materials of a field at a point, 0..1; 0 without materials.
double hardness_at(const Field& field, const Vec3d& p);
/// The coat of a node, by the same rule.
Coat coat_at(const Node& node, const Vec3d& p);

/// The materials that may occur in a field, each name once, ordered by name. Empty if nothing
/// assigns a material. Deferred fields that have not been computed do not contribute.
std::vector<RockMaterialPtr> materials_of(const Field& field);

/// The materials at points, evaluated in parallel. They refer to materials that the field owns.
std::vector<MaterialMix> materials_at(const Field& field, const std::vector<Vec3f>& points);

}  // namespace vug::field

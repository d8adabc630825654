// SPDX-License-Identifier: Apache-2.0
// The solids of a scene, for questions about single points before anything is built.
#pragma once

#include <vug/base/transform.h>
#include <vug/field/field.h>
#include <vug/mesh/distance.h>
#include <vug/shot/shot.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::loading {

/// With `bounds`, deferred fields are not computed: the speleothems of `dripstone` are unknown.
/// `exact` computes them, as the build does.
enum class Accuracy { bounds, exact };

/// A field or a mesh with its transform.
struct Solid {
  std::string name;    ///< The name of the object.
  field::Field field;  ///< In its own space, cut as for its level set; used without a mesh.
  mesh::MeshPtr mesh;  ///< The mesh of a file or of stems; may be null.
  Box3d box;           ///< Contains it in the scene; may be infinite.
  double voxel = 0;    ///< The voxel size of its level set, in its own space; 0 for a mesh.
  double slack = 0;    ///< The surface may deviate from the field by this length in metres.
  render::MaterialPtr material;  ///< Null: an opaque grey.
  bool shines = false;           ///< Its surface emits light.
  Transform to_scene;
  Transform to_own;
  mutable std::shared_ptr<mesh::MeshDistance> distances;  ///< To the mesh; made when it is needed.

  /// Whether its material lets rays into the solid: water, glass, leaves. `p`: where masks of the
  /// material are evaluated.
  bool is_clear(const Vec3d& p) const;
  /// Whether light from inside leaves it: also calcite and ice, with subsurface scattering.
  bool is_translucent(const Vec3d& p) const;
  /// Whether the point is certainly inside.
  bool contains(const Vec3d& p, Accuracy accuracy) const;
  /// Whether the level set contains a point that the field does not: its samples are too far apart.
  bool voxels_contain(const Vec3d& p, Accuracy accuracy) const;
  /// A length by which the point is at least inside, without a margin; 0 if that is not certain.
  double depth(const Vec3d& p, Accuracy accuracy) const;
  /// Whether the surface is farther from a point outside than `distance`, as far as is known.
  bool is_farther(const Vec3d& p, double distance, Accuracy accuracy) const;
};

/// The solids of an object, without a transform; several if its mesh combines several.
std::vector<Solid> solids_of(const shot::ObjectPlan& object);

/// The solid at another place.
Solid moved(Solid solid, const Transform& by);

}  // namespace vug::loading

// SPDX-License-Identifier: Apache-2.0
// Sources of meshes that need no grid: stems, the polygons of an L-system, and leaf shapes.
#pragma once

#include <vug/field/field.h>
#include <vug/mesh/mesh.h>
#include <vug/shot/shot.h>

namespace vug::shot {

struct MeshSource {
  field::Field stems;
  LSystemPtr polygons;  ///< Null: the stems.
  mesh::MeshPtr shape;  ///< If set, used instead of both.
};

/// The mesh of a source, with unit normals. Stems are approximated within `tolerance` metres of a
/// round cross-section; polygons become sheets. The mesh is empty if nothing has been drawn, as in
/// an animation before growth starts. Error(bad_input) for a field that does not consist of stems,
/// and for self-intersecting polygons.
mesh::Mesh mesh_from_source(const MeshSource& drawn, double tolerance);

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::MeshSource> {
  static std::string type() { return "stems, lsystem or shape"; }
  static std::optional<shot::MeshSource> read(const Value& value);
  static Value write(const shot::MeshSource&) { return {}; }
};

}  // namespace vug

// What a mesh can be made of without a grid: stems, the polygons of an L-system, a leaf.
#pragma once

#include <vug/field/field.h>
#include <vug/mesh/mesh.h>
#include <vug/shot/shot.h>

namespace vug::shot {

struct MeshSource {
  field::Field stems;
  LSystemPtr polygons;  ///< Null where it is of stems.
  mesh::MeshPtr shape;  ///< In place of both.
};

/// With unit normals. Stems are cut into edges no further than `tolerance` metres from round;
/// polygons make sheets. Where nothing is drawn it is empty, as in a film before anything grows.
/// Error(bad_input) for a field that is not of stems, and for polygons that cross themselves.
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

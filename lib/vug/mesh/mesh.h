// SPDX-License-Identifier: Apache-2.0
// Triangle meshes as plain data, shared by the mesher, the renderer and the file formats. Positions
// are in metres in world space, right-handed, y up. Triangles are anticlockwise seen from outside,
// so (b - a) x (c - a) points out of the solid.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/vec.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vug::mesh {

/// Numbers at every vertex; "Cd" with arity 3 is linear scene-referred colour.
struct Attribute {
  std::string name;
  int arity = 1;
  std::vector<float> values;  ///< `arity` numbers per vertex, vertex by vertex.

  bool operator==(const Attribute&) const = default;
};

/// Vertex indices of a triangle's corners.
using Triangle = std::array<uint32_t, 3>;

struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  std::vector<Vec3f> normals;  ///< Unit length, one per vertex, or empty.
  std::vector<Attribute> attributes;

  bool operator==(const Mesh&) const = default;
};

/// A finished mesh that is shared and immutable.
using MeshPtr = std::shared_ptr<const Mesh>;

/// Name of the colour attribute.
inline constexpr std::string_view kColour = "Cd";

/// Returns the attribute with this name (and arity, unless 0), or null.
const Attribute* find_attribute(const Mesh& mesh, std::string_view name, int arity = 0);

/// The corners of triangle `face` in double precision.
std::array<Vec3d, 3> corners(const Mesh& mesh, size_t face);

/// (b - a) x (c - a) of triangle `face`: outward, twice the area long.
Vec3d double_area_vector(const Mesh& mesh, size_t face);

/// The bounding box of all positions; empty for a mesh without vertices.
Box3d bounds(const Mesh& mesh);

/// Digest of the content: equal meshes have equal digests on any machine.
Digest digest(const Mesh& mesh);

/// Throws Error(bad_input), naming `what`, unless indices are in range, arrays have the expected
/// length and every number is finite.
void validate(const Mesh& mesh, const std::string& what);

}  // namespace vug::mesh

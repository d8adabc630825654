// Triangle meshes as plain data: what the mesher makes, the renderer draws and files hold.
// Positions are in metres in world space, right-handed, y up. Triangles run anticlockwise seen
// from outside, so that (b - a) x (c - a) points out of the solid.
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

/// Numbers carried by every vertex; "Cd" of arity 3 is linear scene-referred colour.
struct Attribute {
  std::string name;
  int arity = 1;
  std::vector<float> values;  ///< arity numbers for each vertex, vertex by vertex.

  bool operator==(const Attribute&) const = default;
};

/// Indices of a triangle's corners.
using Triangle = std::array<uint32_t, 3>;

struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  std::vector<Vec3f> normals;  ///< Unit length, one for each vertex, or empty.
  std::vector<Attribute> attributes;

  bool operator==(const Mesh&) const = default;
};

/// How a finished mesh is passed about.
using MeshPtr = std::shared_ptr<const Mesh>;

/// Name of the colour attribute.
inline constexpr std::string_view kColour = "Cd";

/// The attribute of that name (and arity, unless 0), null when there is none.
const Attribute* find_attribute(const Mesh& mesh, std::string_view name, int arity = 0);

/// The corners of triangle `face` in double precision.
std::array<Vec3d, 3> corners(const Mesh& mesh, size_t face);

/// (b - a) x (c - a) of triangle `face`: outward, twice the area long.
Vec3d double_area_vector(const Mesh& mesh, size_t face);

/// The box around all positions; empty for a mesh without vertices.
Box3d bounds(const Mesh& mesh);

/// Identity of the content: equal meshes, equal digests, on any machine.
Digest digest(const Mesh& mesh);

/// Throws Error(bad_input), naming `what`, unless indices are in range, arrays have the length
/// they promise and every number is finite.
void validate(const Mesh& mesh, const std::string& what);

}  // namespace vug::mesh

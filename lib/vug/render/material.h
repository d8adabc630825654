// The seam of materials: from a place on a surface to how light scatters there.
#pragma once

#include <vug/render/bsdf.h>

#include <memory>

namespace vug::render {

/// What a material may read at a hit.
struct Surface {
  Vec3f position;
  Vec3f geometric_normal;  ///< Unit, on the side of the viewer.
  Vec3f shading_normal;  ///< Unit, on the side of the viewer; interpolated where the mesh has any.
  Rgb color{1, 1, 1};    ///< Vertex colour "Cd", white without.
  bool inside = false;   ///< The viewer is on the back of the triangle: inside of a solid.
};

/// Shared and immutable. What varies over the surface is read once for a hit.
class Material {
 public:
  virtual ~Material() = default;
  /// How the surface scatters towards `out` (local, z > 0). What is returned stands in `memory`
  /// and lives as long as that.
  virtual const Bsdf& at(const Surface& surface, const Vec3f& out, BsdfMemory& memory) const = 0;
  /// Bytes of a BsdfMemory that `at` takes.
  virtual size_t memory_bytes() const = 0;
};
using MaterialPtr = std::shared_ptr<const Material>;

}  // namespace vug::render

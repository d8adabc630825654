// The seam of materials: from a place on a surface to how light scatters there.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/render/bsdf.h>

#include <cstdint>
#include <memory>

namespace vug::exchange {
struct Look;
}
namespace vug::field {
class SampledGrid;
}
namespace vug::mesh {
struct Mesh;
}

namespace vug::render {

class InstanceTransform;

class AttributeGradients;  ///< See mesh_slopes.h.

/// What a material may read at a hit.
struct Surface {
  Vec3f position;
  Vec3f geometric_normal;  ///< Unit, on the side of the viewer.
  Vec3f shading_normal;  ///< Unit, on the side of the viewer; interpolated where the mesh has any.
  Rgb color{1, 1, 1};    ///< Vertex colour "Cd", white without.
  bool inside = false;   ///< The viewer is on the back of the triangle: inside of a solid.
  float footprint = 0;   ///< Metres across which the viewer takes in, about.
  float blur = 0;        ///< Faces are to be this rough at least: see path(regularize: ...).

  const mesh::Mesh* mesh = nullptr;  ///< Null: none, as in tests.
  uint32_t triangle = 0;             ///< Of the mesh, and the place on it: shares of the second and
  float u = 0, v = 0;                ///< third corner.
  const AttributeGradients* gradients = nullptr;  ///< Of the mesh, for bumps.
  const field::SampledGrid* solid = nullptr;  ///< The level set that the mesh was made of, if any.
  const InstanceTransform* instance = nullptr;  ///< Of an instance; else null.
  bool world_space_material = false;            ///< See Object.
  float time = 0;                               ///< Of the ray; see InstanceTransform.

  /// Bends a shading normal back that turns away from the viewer, until it just faces them.
  void face(const Vec3f& travel) {
    const float facing = -dot(shading_normal, travel);
    if (facing < 0.01f) shading_normal = normalized(shading_normal - travel * (0.01f - facing));
  }
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

  /// See Bsdf::thin: all or nothing of a material.
  virtual bool thin() const { return false; }
  /// It sends out light by itself, from the outside of what is made of it, as `emission` says:
  /// radiance (W/sr/m^2), the same in all directions.
  virtual bool is_emissive() const { return false; }
  virtual Rgb emission(const Surface& surface) const { return (void)surface, Rgb(0.0f); }

  /// It has holes, or is there only in part: rays pass through with the chance that `opacity`
  /// leaves, as if nothing were there. The normal of that surface is not bent by bumps yet.
  virtual bool cut_out() const { return false; }
  virtual float opacity(const Surface& surface) const { return (void)surface, 1.0f; }

  /// Bends the shading normal over small forms, before `at`; false where it stays.
  virtual bool bump(Surface& surface) const { return (void)surface, false; }
  /// Light that was scattered beneath the surface (BsdfSample::beneath) and comes out here; the
  /// surface is seen from outside. Null where nothing goes beneath.
  virtual const Bsdf* subsurface_exit(const Surface& surface, BsdfMemory& memory) const {
    (void)surface, (void)memory;
    return nullptr;
  }

  /// Share of the place that water covers, 0 to 1.
  virtual float wetness(const Surface& surface) const { return (void)surface, 0.0f; }

  /// What it looks like there to programs that know one mix of lobes, but for its emission; without
  /// more a matte body that reflects as much light as this does seen from above.
  virtual exchange::Look look(const Surface& surface) const;

  /// The same material for light in other primaries: `from_rec709` leads there from linear Rec.709,
  /// in which its parameters, paints and vertex colours are.
  virtual std::shared_ptr<const Material> in_space(
      const image::ColourMatrix& from_rec709) const = 0;
};
using MaterialPtr = std::shared_ptr<const Material>;

}  // namespace vug::render

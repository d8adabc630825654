// SPDX-License-Identifier: Apache-2.0
// Interface of materials: provides the BSDF at a point on a surface.
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

class AttributeGradients;  ///< See attribute_gradients.h.

/// Surface properties at a hit, as materials read them.
struct Surface {
  Vec3f position;
  Vec3f geometric_normal;  ///< Unit, on the viewer's side.
  Vec3f shading_normal;    ///< Unit, on the viewer's side; interpolated if the mesh has normals.
  Rgb color{1, 1, 1};      ///< Vertex colour "Cd"; white without one.
  bool inside = false;     ///< The viewer sees the back of the triangle, from inside a solid.
  float footprint =
      0;           ///< Approximate diameter in metres of the area that the viewer's ray covers.
  float blur = 0;  ///< Minimum roughness of specular lobes: see path(regularize: ...).
  /// Variance per axis of the slopes of bumps that are smaller than the footprint, set by
  /// Material::bump. It widens specular lobes: see filtered_roughness.
  float slope_variance = 0;

  const mesh::Mesh* mesh = nullptr;  ///< Null: no mesh, as in tests.
  uint32_t triangle = 0;             ///< Index in the mesh, and the barycentric weights of the
  float u = 0, v = 0;                ///< second and third corner.
  const AttributeGradients* gradients = nullptr;  ///< For bump mapping by attributes.
  const field::SampledGrid* solid =
      nullptr;  ///< The level set from which the mesh was made, if any.
  const InstanceTransform* instance = nullptr;  ///< Null if the object is not an instance.
  bool world_space_material = false;            ///< See Object.
  float time = 0;                               ///< Shutter time of the ray; see InstanceTransform.

  /// Turns a shading normal that faces away from the viewer back until it just faces the viewer.
  void face(const Vec3f& travel) {
    const float facing = -dot(shading_normal, travel);
    if (facing < 0.01f) shading_normal = normalized(shading_normal - travel * (0.01f - facing));
  }
};

/// Shared and immutable. Spatially varying parameters are read once per hit.
class Material {
 public:
  virtual ~Material() = default;
  /// Returns the BSDF for light scattered towards `out` (local, z > 0). It is stored in `memory`
  /// and lives as long as `memory`.
  virtual const Bsdf& at(const Surface& surface, const Vec3f& out, BsdfMemory& memory) const = 0;
  /// Bytes of a BsdfMemory that `at` uses.
  virtual size_t memory_bytes() const = 0;

  /// See Bsdf::thin; it holds for all of a material or none of it.
  virtual bool thin() const { return false; }
  /// True if the outer side of the surface emits light. `emission` is its radiance (W/sr/m^2), the
  /// same in all directions.
  virtual bool is_emissive() const { return false; }
  virtual Rgb emission(const Surface& surface) const { return (void)surface, Rgb(0.0f); }

  /// True if the surface has holes or is partly transparent: rays pass through unaffected with the
  /// probability 1 - `opacity`. The normal of that surface does not include bumps yet.
  virtual bool cut_out() const { return false; }
  virtual float opacity(const Surface& surface) const { return (void)surface, 1.0f; }

  /// Applies the bump map to the shading normal, as far as the footprint resolves it, and sets the
  /// variance of the other slopes, before `at`; false if the normal stays unchanged.
  virtual bool bump(Surface& surface) const { return (void)surface, false; }
  /// The lobe of light that was scattered below the surface (BsdfSample::subsurface) and leaves it
  /// here, seen from outside. Null without subsurface scattering.
  virtual const Bsdf* subsurface_exit(const Surface& surface, BsdfMemory& memory) const {
    (void)surface, (void)memory;
    return nullptr;
  }

  /// Fraction of the point that is covered by water, 0 to 1.
  virtual float wetness(const Surface& surface) const { return (void)surface, 0.0f; }

  /// Approximation by a single mix of lobes for exporters, without emission; by default a diffuse
  /// surface with this material's albedo at normal incidence.
  virtual exchange::Look look(const Surface& surface) const;

  /// Whether a mask or a paint refers to the scene, so that the instances of an object differ even
  /// if the material is evaluated in the mesh's own space.
  virtual bool refers_to_scene() const { return false; }

  /// The same material for light in other primaries. `from_rec709` converts from linear Rec.709,
  /// the space of its parameters, paints and vertex colours.
  virtual std::shared_ptr<const Material> in_space(
      const image::ColourMatrix& from_rec709) const = 0;
};
using MaterialPtr = std::shared_ptr<const Material>;

}  // namespace vug::render

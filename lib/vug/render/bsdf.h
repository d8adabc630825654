// The seam of materials: how a surface scatters light.
#pragma once

#include <vug/render/vectors.h>

#include <memory>

namespace vug::render {

/// What a material may read at a hit.
struct Surface {
  Vec3f position;
  Vec3f geometric_normal;  ///< Unit, on the side of the viewer.
  Vec3f shading_normal;  ///< Unit, on the side of the viewer; interpolated where the mesh has any.
  Rgb color{1, 1, 1};    ///< Vertex colour "Cd", white without.
};

struct BsdfSample {
  Vec3f direction;  ///< Local, unit; zero pdf means: nothing was sampled.
  Rgb weight;       ///< f |cos| / pdf.
  float pdf = 0;    ///< Over solid angle.
};

/// Directions are unit vectors in the local frame of the shading normal (z), pointing away from
/// the surface; `out` (towards the viewer) has z > 0. Reflects only the side the viewer is on.
class Bsdf {
 public:
  virtual ~Bsdf() = default;
  /// f(out, in) * |cos in|, in 1/sr.
  virtual Rgb evaluate(const Surface& surface, const Vec3f& out, const Vec3f& in) const = 0;
  /// Density with which `sample` chooses `in`, over solid angle.
  virtual float pdf(const Surface& surface, const Vec3f& out, const Vec3f& in) const = 0;
  virtual BsdfSample sample(const Surface& surface, const Vec3f& out, float lobe,
                            const Vec2f& u) const = 0;
  /// Share of light that is reflected, about: the picture's albedo layer.
  virtual Rgb albedo(const Surface& surface) const = 0;
};
using BsdfPtr = std::shared_ptr<const Bsdf>;

}  // namespace vug::render

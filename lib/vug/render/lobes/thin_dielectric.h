// A clear sheet too thin to bend light: facets reflect, at either face and between both, and the
// rest goes straight on (Pharr, Jakob, Humphreys 2023, section 9.5, cite pharr2023pbr), spread as
// much as what is reflected. What facets scatter among themselves leaves on both sides, in even
// shares.
#pragma once

#include <vug/render/lobes/lobe.h>

namespace vug::render {

/// Share of light that a smooth sheet reflects at a cosine.
inline float thin_dielectric_reflectance(float cosine, float ior) {
  const float once = fresnel(cosine, ior);
  return 2 * once / (1 + once);
}

/// The same over even light.
float mean_thin_dielectric_reflectance(float ior);

class ThinDielectricLobe {
 public:
  /// `mean`: mean_thin_dielectric_reflectance. `color`: of the light that is let through.
  ThinDielectricLobe(const Rgb& color, float roughness, float ior, float mean, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(mean_) + color_ * (1 - mean_); }

 private:
  Rgb color_;
  Ggx ggx_;
  Vec3f out_;
  float roughness_, ior_, mean_;
  float missing_out_,
      missing_;  ///< What single scattering loses of the viewer's and of even light.
};

}  // namespace vug::render

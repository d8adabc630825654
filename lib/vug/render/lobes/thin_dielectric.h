// SPDX-License-Identifier: Apache-2.0
// A clear sheet too thin to shift light sideways. Facets reflect at both interfaces and between
// them, and the remaining light is transmitted straight on (Pharr, Jakob, Humphreys 2023, section
// 9.5, cite pharr2023pbr) with the same spread as the reflection. Multiple scattering leaves
// diffusely on both sides.
#pragma once

#include <vug/render/lobes/lobe.h>

namespace vug::render {

/// Reflected fraction of a smooth sheet at a cosine.
inline float thin_dielectric_reflectance(float cosine, float ior) {
  const float single = fresnel(cosine, ior);
  return 2 * single / (1 + single);
}

/// Its cosine-weighted mean.
float mean_thin_dielectric_reflectance(float ior);

class ThinDielectricLobe {
 public:
  /// `mean`: mean_thin_dielectric_reflectance. `color` of the transmitted light.
  ThinDielectricLobe(const Rgb& color, float roughness, float ior, float mean, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(mean_) + color_ * (1 - mean_); }
  bool glossy() const { return ggx_.glossy(); }

 private:
  Rgb color_;
  Ggx ggx_;
  Vec3f out_;
  float roughness_, ior_, mean_;
  float missing_out_,
      missing_;  ///< Fractions of the viewer's light and of diffuse light missing from single
                 ///< scattering.
};

}  // namespace vug::render

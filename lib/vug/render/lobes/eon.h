// SPDX-License-Identifier: Apache-2.0
// Rough diffuse rock: the energy-preserving Oren-Nayar reflection of Portsmouth, Kutz and Hill
// 2025, "EON: A practical energy-preserving rough diffuse BRDF" (cite portsmouth2025eon). Roughness
// 0 is Lambertian.
#pragma once

#include <vug/render/lobes/lobe.h>

namespace vug::render {

class EonLobe {
 public:
  EonLobe(const Rgb& color, float roughness, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float, const Vec2f& u) const { return sample_cosine_hemisphere(u); }
  Rgb albedo() const { return single_ * albedo_out_ + multiple_ * (1 - albedo_out_); }

 private:
  Rgb single_, multiple_;  ///< Colour of single and of multiple scattering.
  float roughness_, scale_, albedo_out_, missing_;
  Vec3f out_;
};

}  // namespace vug::render

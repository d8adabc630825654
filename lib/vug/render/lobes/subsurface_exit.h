// SPDX-License-Identifier: Apache-2.0
// The inner side of an interface, for light that leaves a scattering body.
#pragma once

#include <vug/render/lobes/clear_coat.h>

namespace vug::render {

/// Light that leaves a body through its interface, as if it were diffuse inside.
class SubsurfaceExitBsdf final : public Bsdf {
 public:
  SubsurfaceExitBsdf(float roughness, const InterfaceTable& face)
      : face_(roughness, face, {0, 0, 1}) {}

  Scattering evaluate(const Vec3f& in) const override {
    if (!(in.z > 0)) return {};
    const float even = in.z / kPif;
    return {Rgb(face_.transmittance(in.z) / (1 - face_.mean) * even), Rgb(0.0f), even};
  }
  BsdfSample sample(float, const Vec2f& u) const override {
    const Vec3f in = sample_cosine_hemisphere(u);
    const Scattering s = evaluate(in);
    if (!(s.pdf > 0)) return {};
    return {in, s.diffuse * (1 / s.pdf), s.diffuse * (1 / s.pdf), s.pdf};
  }
  Rgb albedo() const override { return Rgb(1.0f); }

 private:
  InterfaceLayer face_;
};

}  // namespace vug::render

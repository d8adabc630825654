// SPDX-License-Identifier: Apache-2.0
// A layer of fibres over a diffuse base: moss. The fibres have the slope distribution of Estevez
// and Kulla 2017, "Production friendly microfacet sheen BRDF" (cite estevez2017sheen), scaled where
// they would reflect more than they receive; the light that they reflect is missing from the base.
#pragma once

#include <vug/render/lobes/lobe.h>

namespace vug::render {

class FuzzLobe {
 public:
  FuzzLobe(const Rgb& fibres, float roughness, const Rgb& below, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float, const Vec2f& u) const { return sample_cosine_hemisphere(u); }
  Rgb albedo() const { return fibres_ * (1 - clear_) + below_ * clear_; }

 private:
  Rgb fibres_, below_;
  Vec3f out_;
  float roughness_, scale_, clear_, mean_clear_;
};

}  // namespace vug::render

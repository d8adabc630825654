// SPDX-License-Identifier: Apache-2.0
// Rough dielectric interface of a clear body: water, ice, crystal. Facets reflect and refract
// (Walter et al. 2007, cite walter2007ggx); multiple scattering leaves diffusely on both sides,
// distributed such that the lobe is reciprocal and conserves energy (cite kulla2017compensation).
#pragma once

#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/lobe.h>

namespace vug::render {

class DielectricLobe {
 public:
  /// `inside`: the viewer is inside the body.
  DielectricLobe(float roughness, const InterfaceTable& face, const DielectricTable& glass,
                 bool inside, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(1.0f); }
  bool glossy() const { return ggx_.glossy(); }

 private:
  Ggx ggx_;
  Vec3f out_;
  const AlbedoTable *near_, *far_;
  float roughness_;
  float ior_;       ///< Index of the far side over that of the near side.
  float loss_out_;  ///< Fraction of the viewer's light in multiple scattering.
  float back_;      ///< Part of `loss_out_` that returns to the viewer's side.
  float missing_near_, missing_far_;
};

}  // namespace vug::render

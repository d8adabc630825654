// SPDX-License-Identifier: Apache-2.0
// Metal: facets with Schlick's Fresnel approximation (Schlick 1994, cite schlick1994) and multiple
// scattering (cite kulla2017compensation).
#pragma once

#include <vug/render/lobes/lobe.h>

namespace vug::render {

class MetalLobe {
 public:
  /// `color`: reflectance at normal incidence.
  MetalLobe(const Rgb& color, float roughness, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const;
  bool glossy() const { return ggx_.glossy(); }

 private:
  Rgb at(float cosine) const;

  Rgb color_, multiple_;
  Ggx ggx_;
  Vec3f out_;
  float roughness_, missing_out_, missing_;
};

}  // namespace vug::render

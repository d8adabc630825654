// Metal: facets that reflect with Schlick's rise to white at the edge (Schlick 1994, cite
// schlick1994), and give back what they scatter among themselves (cite kulla2017compensation).
#pragma once

#include <vug/render/lobes/lobe.h>

namespace vug::render {

class MetalLobe {
 public:
  /// `color`: reflectance face on.
  MetalLobe(const Rgb& color, float roughness, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const;

 private:
  Rgb at(float cosine) const;

  Rgb color_, again_;
  Ggx ggx_;
  Vec3f out_;
  float roughness_, missing_out_, missing_;
};

}  // namespace vug::render

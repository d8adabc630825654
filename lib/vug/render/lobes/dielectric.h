// A clear body seen through its face: water, ice, crystal. Facets reflect and refract (Walter et
// al. 2007, cite walter2007ggx); what they scatter among themselves leaves evenly on both sides,
// shared out so that the face is reciprocal and loses nothing (cite kulla2017compensation).
#pragma once

#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/lobe.h>

namespace vug::render {

class DielectricLobe {
 public:
  /// `inside`: the viewer is in the body.
  DielectricLobe(float roughness, const InterfaceTable& face, const DielectricTable& glass,
                 bool inside, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(1.0f); }

 private:
  Ggx ggx_;
  Vec3f out_;
  const AlbedoTable *near_, *far_;
  float roughness_;
  float ior_;       ///< Of the far side over the near side.
  float loss_out_;  ///< Share of the viewer's light that is scattered between facets,
  float back_;      ///< and the part of that which comes back to the viewer's side.
  float missing_near_, missing_far_;
};

}  // namespace vug::render

// A leaf, a curtain of calcite: a face over a sheet so thin that light which goes in comes out
// behind at the same place, evenly, through a face like the first. Coupled as in ClearCoatLobe, so
// that nothing is lost and both directions count alike (cite kelemen2001coupled).
#pragma once

#include <vug/render/lobes/clear_coat.h>

namespace vug::render {

class ThinSheetLobe {
 public:
  /// `color`: what the sheet lets through of the light that goes in.
  ThinSheetLobe(const Rgb& color, float roughness, const InterfaceTable& face, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(1 - share_.clear) + color_ * share_.clear; }

 private:
  ClearCoatLobe face_;
  InterfaceLayer share_;
  Rgb color_;
  float specular_probability_;  ///< Odds of sampling the face.
};

}  // namespace vug::render

// SPDX-License-Identifier: Apache-2.0
// A leaf or a curtain of calcite: an interface over a sheet so thin that light which enters leaves
// on the far side at the same point, diffusely, through an equal interface. Coupled as in
// ClearCoatLobe, so that it conserves energy and is reciprocal (cite kelemen2001coupled).
#pragma once

#include <vug/render/lobes/clear_coat.h>

namespace vug::render {

class ThinSheetLobe {
 public:
  /// `color`: fraction of the light inside the sheet that is transmitted.
  ThinSheetLobe(const Rgb& color, float roughness, const InterfaceTable& face, const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(1 - share_.transmitted) + color_ * share_.transmitted; }

 private:
  ClearCoatLobe face_;
  InterfaceLayer share_;
  Rgb color_;
  float specular_probability_;  ///< Probability of sampling the interface.
};

}  // namespace vug::render

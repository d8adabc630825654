// SPDX-License-Identifier: Apache-2.0
#include <vug/render/lobes/thin_sheet.h>

namespace vug::render {

ThinSheetLobe::ThinSheetLobe(const Rgb& color, float roughness, const InterfaceTable& face,
                             const Vec3f& out)
    : face_(color, ClearCoatLobe::Base::open, roughness, face, out),
      share_(roughness, face, out),
      color_(color) {
  const float reflected = 1 - share_.transmitted, through = share_.transmitted * largest(color);
  specular_probability_ = std::clamp(reflected / (reflected + through), 0.1f, 0.9f);
}

Scattering ThinSheetLobe::evaluate(const Vec3f& in) const {
  if (in.z == 0) return {};
  if (in.z > 0) {
    Scattering s = face_.evaluate(in);
    s.pdf *= specular_probability_;
    return s;
  }
  const float even = -in.z / kPif;
  return {color_ * (share_.transmitted * share_.transmittance(-in.z) / (1 - share_.mean) * even),
          Rgb(0.0f), (1 - specular_probability_) * even};
}

Vec3f ThinSheetLobe::sample(float lobe, const Vec2f& u) const {
  if (lobe < specular_probability_)
    return face_.sample(std::min(lobe / specular_probability_, 0x1.fffffep-1f), u);
  Vec3f in = sample_cosine_hemisphere(u);
  in.z = -in.z;
  return in;
}

}  // namespace vug::render

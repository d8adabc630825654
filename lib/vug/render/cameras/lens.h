// SPDX-License-Identifier: Apache-2.0
// Thin lens with an aperture: a disk, or a regular polygon between straight blades.
#pragma once

#include <vug/base/maths.h>
#include <vug/base/schema.h>
#include <vug/render/sampling.h>

#include <algorithm>
#include <optional>
#include <string>

namespace vug::render {

struct LensParams {
  double aperture = 0;
  std::optional<double> focus;
  int blades = 0;
  double blade_turn = 0;

  std::string lens_fault() const {
    return blades == 1 || blades == 2 ? "'blades' must be 0 or at least 3" : "";
  }
};

template <class P>
Schema<P>& describe_lens(Schema<P>& s) {
  return s
      .param("aperture", &P::aperture,
             {.doc = "Diameter of the aperture; 0: everything is in focus.",
              .dimension = Dimension::length,
              .min = 0})
      .param("focus", &P::focus,
             positive_length("Distance of the plane in focus; by default that of the target."))
      .param("blades", &P::blades,
             {.doc = "Corners of the aperture, on a circle of its diameter; 0: a round aperture.",
              .min = 0,
              .max = 64})
      .param("blade_turn", &P::blade_turn,
             {.doc = "Rotation of the aperture; at 0 a corner points up.",
              .dimension = Dimension::angle});
}

/// Uniform points on an aperture of radius 1, x to the right and y up.
class ApertureShape {
 public:
  explicit ApertureShape(const LensParams& p)
      : blades_(p.blades), turn_(static_cast<float>(p.blade_turn / (2 * kPi))) {
    turn_ -= std::floor(turn_);
  }
  Vec2f sample(const Vec2f& u) const {
    if (blades_ < 3) return sample_disk(u);
    const auto count = static_cast<float>(blades_);
    const float along = u.x * count;
    const float blade = std::min(std::floor(along), count - 1);
    // A uniform point on the triangle of the centre and two corners.
    const float out = std::sqrt(u.y), across = std::min(along - blade, 1.0f);
    const Vec2f a = corner(blade / count), b = corner((blade + 1) / count);
    return (a * (1 - across) + b * across) * out;
  }

 private:
  /// Corner at an angle in turns to the left of the top.
  Vec2f corner(float turns) const {
    const SinCos sc = sincos_turns(turns + turn_);
    return {-sc.sin, sc.cos};
  }
  int blades_;
  float turn_;
};

}  // namespace vug::render

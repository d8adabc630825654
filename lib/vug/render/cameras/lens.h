// The opening of a lens: round, or a regular polygon between straight blades.
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
    return blades == 1 || blades == 2 ? "an opening between blades has at least 3 of them" : "";
  }
};

template <class P>
Schema<P>& describe_lens(Schema<P>& s) {
  return s
      .param("aperture", &P::aperture,
             {.doc = "Diameter of the lens opening; 0 keeps everything sharp.",
              .dimension = Dimension::length,
              .min = 0})
      .param("focus", &P::focus,
             positive_length("Distance of the sharp plane; the target's when not given."))
      .param("blades", &P::blades,
             {.doc = "Corners of the opening, on a circle of the aperture's diameter; 0: round.",
              .min = 0,
              .max = 64})
      .param("blade_turn", &P::blade_turn,
             {.doc = "Turns the opening; at 0 a corner points up.", .dimension = Dimension::angle});
}

/// Uniform points of an opening of radius 1, x to the right and y up.
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
    // The triangle of the middle and two corners: even over its area.
    const float out = std::sqrt(u.y), across = std::min(along - blade, 1.0f);
    const Vec2f a = corner(blade / count), b = corner((blade + 1) / count);
    return (a * (1 - across) + b * across) * out;
  }

 private:
  /// Turns to the left, beginning with the top.
  Vec2f corner(float turns) const {
    const SinCos sc = sincos_turns(turns + turn_);
    return {-sc.sin, sc.cos};
  }
  int blades_;
  float turn_;
};

}  // namespace vug::render

// SPDX-License-Identifier: Apache-2.0
// A pothole: stones that whirl in the water of a stream drill a round pit, wider at its bottom than
// at its mouth, with a spiral groove down the wall.
#include <vug/field/lathe.h>
#include <vug/field/modifier.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

constexpr double kTurn = 2 * kPi;

/// Moves the wall outwards by up to `depth` along a helix about the y axis.
struct SpiralGroove {
  double radius, depth, pitch, above;

  template <class T>
  T apply(const T& value, const Point<T>& p) const {
    const T turns = atan2(p.z, p.x) * T(1 / kTurn) + p.y * T(1 / pitch);
    const T from_axis = min(length(p.x, p.z) * T(1 / radius), T(1.0));
    // It fades at the mouth, so that the rim stays even.
    const T fade = clamp(-p.y * T(1 / above), T(0.0), T(1.0));
    const T groove = cos(turns * T(kTurn)) * T(0.5) + T(0.5);
    return value - groove * from_axis * fade * T(depth);
  }
  Traits traits(const Traits& child) const {
    Traits out = child;
    // cos(theta) rho / radius has at most the slope 1 / radius in both directions of the plane.
    out.lipschitz =
        child.lipschitz + depth * (std::sqrt(2.0) / radius + 0.5 * kTurn / pitch + 1 / above);
    out.exactness = Exactness::sign;
    out.bounds = grown(child.bounds, depth);
    out.growth = child.growth_rate();
    return out;
  }
  Interval range(Interval child) const { return child - Interval(0, depth); }
};

struct Pothole {
  double diameter = 0.6;
  double depth = 0.9;
  double undercut = 1.2;
  double groove = 0.04;
  double pitch = 0.25;
  double rise = 0.3;

  static void describe(Schema<Pothole>& s) {
    s.doc(
         "The air of a pothole of a stream, whose mouth is at the origin: subtract it from rock. "
         "It widens downwards and has a spiral groove.")
        .param("diameter", &Pothole::diameter,
               positive_length("diameter of the mouth, 10 cm to 2 m in nature"))
        .param("depth", &Pothole::depth, positive_length("depth, mostly 1 to 2 diameters"))
        .param("undercut", &Pothole::undercut,
               {.doc = "greatest diameter over that of the mouth",
                .dimension = Dimension::ratio,
                .min = 0.5,
                .max = 2})
        .param("groove", &Pothole::groove,
               {.doc = "depth of the spiral groove; 0: none",
                .dimension = Dimension::length,
                .min = 0})
        .param("pitch", &Pothole::pitch, positive_length("height of a turn of the groove"))
        .param("rise", &Pothole::rise, positive_length("height of the air above the mouth"));
  }
  std::string fault() const {
    return groove < 0.5 * diameter ? "" : "the groove must be shallower than half of the diameter";
  }
  /// From the bottom, which is rounder than a half-ellipse, up to above the mouth.
  std::vector<Vec2d> outline() const {
    constexpr int kPoints = 24;
    std::vector<Vec2d> out;
    const double mouth = 0.5 * diameter, widest = mouth * undercut, bowl = 0.35 * depth;
    for (int i = 0; i <= kPoints; ++i) {
      const double angle = 0.25 * kTurn * i / kPoints;
      const double c = maths::cos(angle);
      out.emplace_back(widest * std::sqrt(1 - c * c * c * c), -depth + bowl * (1 - c));
    }
    for (int i = 1; i <= kPoints; ++i) {  // The wall closes in like a bottle's shoulder.
      const double t = static_cast<double>(i) / kPoints;
      out.emplace_back(mix(widest, mouth, t * t * (3 - 2 * t)), -(depth - bowl) * (1 - t));
    }
    out.emplace_back(mouth, rise);
    out.emplace_back(0, rise);
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(pothole) {
  return field_kind<Pothole>("pothole", "primitive", [](const Pothole& p) {
    const Field pit = lathe("pothole", p.outline());
    if (p.groove == 0) return pit;
    const SpiralGroove groove{0.5 * p.diameter, p.groove, p.pitch, 0.25 * p.depth};
    return Field(std::make_shared<ModifierNode<SpiralGroove>>("pothole", groove, pit.node()));
  });
}

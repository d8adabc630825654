// SPDX-License-Identifier: Apache-2.0
// A column of ice: an icicle and the ice below it, which met and grew together, with ripples.
#include <vug/base/maths.h>
#include <vug/field/kind.h>
#include <vug/field/lathe.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct FrozenColumn {
  static constexpr int kPointsPerRipple = 6;
  static constexpr double kMostRipples = 400;
  static constexpr int kLeastPoints = 48;

  double height = 2;
  double radius = 0.3;
  double waist = 0.45;
  double meeting = 0.6;
  double ripple = 0.009;
  double relief = 0.0015;
  double root = 0.1;

  static void describe(Schema<FrozenColumn>& s) {
    s.doc(
         "A frozen column that stands at the origin, widest at both ends, with the ripples of "
         "icicles, which are about 9 mm long whatever its size.")
        .cite("ueno2007")
        .param("height", &FrozenColumn::height, positive_length("height from floor to roof"))
        .param("radius", &FrozenColumn::radius, positive_length("radius at the floor"))
        .param("waist", &FrozenColumn::waist,
               {.doc = "radius of the waist over that at the floor",
                .dimension = Dimension::ratio,
                .min = 0.1,
                .max = 1})
        .param("meeting", &FrozenColumn::meeting,
               {.doc = "height of the waist over the whole height",
                .dimension = Dimension::ratio,
                .min = 0.2,
                .max = 0.8})
        .param("ripple", &FrozenColumn::ripple,
               positive_length("wavelength of the ripples, 8 to 10 mm in nature"))
        .param("relief", &FrozenColumn::relief,
               {.doc = "height of the ripples; 0: none", .dimension = Dimension::length, .min = 0})
        .param("root", &FrozenColumn::root,
               {.doc = "length by which it continues into floor and roof",
                .dimension = Dimension::length,
                .min = 0});
  }
  std::string fault() const {
    if (!(relief < 0.5 * waist * radius)) return "the ripples must be lower than half of the waist";
    return relief == 0 || height / ripple <= kMostRipples
               ? ""
               : "a column can have at most 400 ripples; increase 'ripple' or set 'relief' to 0";
  }
  /// Without ripples: two parabolas that meet in the waist; the upper end is 0.8 of the lower one.
  double side(double y) const {
    const double part = y / height, thin = waist * radius;
    const double away =
        part < meeting ? (meeting - part) / meeting : (part - meeting) / (1 - meeting);
    const double end = part < meeting ? radius : std::max(0.8 * radius, thin);
    return thin + (end - thin) * away * away;
  }
  std::vector<Vec2d> outline() const {
    const bool rippled = relief > 0;
    const int count =
        std::max(rippled ? static_cast<int>(std::ceil(height / ripple)) * kPointsPerRipple : 0,
                 kLeastPoints);
    std::vector<Vec2d> out = {Vec2d(0, -root)};
    if (root > 0) out.emplace_back(side(0), -root);
    for (int i = 0; i <= count; ++i) {
      const double y = height * i / count;
      const double wave = rippled ? relief * 0.5 * (1 - maths::cos(2 * kPi * y / ripple)) : 0;
      out.emplace_back(side(y) + wave, y);
    }
    if (root > 0) out.emplace_back(side(height), height + root);
    out.emplace_back(0, height + root);
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(frozen_column) {
  return field_kind<FrozenColumn>("frozen_column", "primitive", [](const FrozenColumn& c) {
    return lathe("frozen_column", c.outline());
  });
}

// SPDX-License-Identifier: Apache-2.0
// Ledges along walls at exact heights, as water or lava leaves them at the level where it stood.
#pragma once

#include <vug/field/lattice.h>
#include <vug/field/modifier.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::field {

/// The union of a solid and, at each level, the places below the level and within a width of the
/// solid. The underside slopes: a ledge is thick at the wall and thin at its rim. Every part is
/// divided by its slope, so the value stays as steep as that of the solid.
struct Ledge {
  std::vector<double> levels;  ///< Heights of the flat tops, metres.
  double width = 0.1;          ///< Mean distance of the rim from the solid, metres.
  double wander = 0.5;         ///< Variation of the width, 0..1.
  double root = 0.05;          ///< Thickness at the wall, metres; at least that of the rim.
  double rim = 0.01;           ///< Thickness at the mean width and beyond, metres.
  Vec3d wave_a, wave_b;        ///< Waves of the variation per metre, along two directions.
  uint32_t seed = 0;

  template <class T>
  T apply(const T& value, const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return range(value);
    } else {
      T reach(width);
      if (wander > 0) {
        const Point<T> q{dot(p, constant<T>(wave_a)), dot(p, constant<T>(wave_b)), T(0.5)};
        reach = reach + clamp(gradient_noise(q, seed), T(-1.0), T(1.0)) * T(width * wander);
      }
      const T beyond = (value - reach) * T(1 / (1 + wave_slope()));
      const T thick = max(T(root) - max(value, T(0.0)) * T(taper()), T(rim));
      T out = value;
      for (const double level : levels) {
        const T above = p.y - T(level);
        const T below = -(above + thick) * T(1 / (1 + taper()));
        out = min(out, max(max(above, below), beyond));
      }
      return out;
    }
  }
  Traits traits(const Traits& child) const { return layer().traits(child); }
  Interval range(Interval child) const { return layer().range(child); }

 private:
  GrownLayer layer() const { return {width * (1 + wander), wave_slope()}; }
  double taper() const { return (root - rim) / width; }
  double wave_slope() const {
    return width * wander * kGradientNoiseSlope * std::sqrt(wave_a.length2() + wave_b.length2());
  }
};

}  // namespace vug::field

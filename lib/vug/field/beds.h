// SPDX-License-Identifier: Apache-2.0
// Parameters and layers of bedded rock, shared by the noise `beds` and the detail `strata`.
#pragma once

#include <vug/field/noise.h>

namespace vug::field {

struct BedParams {
  double thickness = 0.6;  ///< Mean thickness of a bed, metres.
  Vec3d normal{0, 1, 0};   ///< Perpendicular to the beds, of any length except 0.
  double ledge = 0.3;      ///< Fraction of the mean thickness over which a ledge rises.
  double laminae = 0.25;   ///< Strength of the thin layers within the beds.
  double wander = 0.1;     ///< Deviation of the bed surfaces from planes, metres ...
  double reach = 8;        ///< ... and the wavelength of the deviation, metres.
  int seed = 1;

  std::string fault() const { return normal.length2() > 0 ? "" : "the normal must not be zero"; }
};

template <class P>
Schema<P>& describe_beds(Schema<P>& s) {
  return s.param("thickness", &BedParams::thickness, positive_length("mean thickness of a bed"))
      .param("normal", &BedParams::normal,
             {.doc = "perpendicular to the beds; tilt it to make them dip"})
      .param("ledge", &BedParams::ledge,
             {.doc = "fraction of the mean thickness over which a ledge rises; smaller is sharper",
              .dimension = Dimension::ratio,
              .min = 0.02,
              .max = 1})
      .param("laminae", &BedParams::laminae,
             {.doc = "strength of the thin layers within the beds", .min = 0, .max = 1})
      .param("wander", &BedParams::wander,
             {.doc = "deviation of the bed surfaces from planes",
              .dimension = Dimension::length,
              .min = 0})
      .param("reach", &BedParams::reach, positive_length("wavelength of the deviation"))
      .param("seed", &BedParams::seed, {.doc = "random seed; each seed gives different beds"});
}

/// 1 on the face of the hardest bed, -1 in the notch of the softest, 0 at the bed boundaries.
Noise layered_rock(const BedParams& params);

}  // namespace vug::field

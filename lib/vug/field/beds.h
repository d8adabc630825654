// A stack of layered rock: what the noise `beds` and the detail `strata` have in common.
#pragma once

#include <vug/field/noise.h>

namespace vug::field {

struct BedParams {
  double thickness = 0.6;  ///< Mean of a bed, metres.
  Vec3d normal{0, 1, 0};   ///< Across the beds, of any length but 0.
  double ledge = 0.3;      ///< Part of the mean thickness in which a ledge rises.
  double laminae = 0.25;   ///< Strength of the thin layers within the beds.
  double wander = 0.1;     ///< How far bed surfaces stray from planes, metres ...
  double reach = 8;        ///< ... and over which distance, metres.
  int seed = 1;

  std::string fault() const { return normal.length2() > 0 ? "" : "the normal needs a direction"; }
};

template <class P>
Schema<P>& describe_beds(Schema<P>& s) {
  return s.param("thickness", &BedParams::thickness, positive_length("mean thickness of a bed"))
      .param("normal", &BedParams::normal, {.doc = "across the beds; tilt it to make them dip"})
      .param("ledge", &BedParams::ledge,
             {.doc = "part of the mean thickness in which a ledge rises; smaller is sharper",
              .dimension = Dimension::ratio,
              .min = 0.02,
              .max = 1})
      .param("laminae", &BedParams::laminae,
             {.doc = "strength of the thin layers within the beds", .min = 0, .max = 1})
      .param("wander", &BedParams::wander,
             {.doc = "how far bed surfaces stray from planes",
              .dimension = Dimension::length,
              .min = 0})
      .param("reach", &BedParams::reach, positive_length("over which they stray"))
      .param("seed", &BedParams::seed, {.doc = "another seed, other beds"});
}

/// 1 on the face of the hardest bed, -1 in the notch of the softest, 0 where beds part.
Noise layered_rock(const BedParams& params);

}  // namespace vug::field

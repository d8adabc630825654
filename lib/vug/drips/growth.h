// SPDX-License-Identifier: Apache-2.0
// The growth of stalactites and stalagmites from the water of their drip.
#pragma once

#include <vug/drips/graph.h>
#include <vug/field/speleothems/stalactite_curve.h>

#include <optional>

namespace vug::drips {

/// The curve of all stalactites of a cave, by the radius in metres of one that is a metre long.
field::StalactiteCurve common_curve(double girth);

/// The radius in metres at the root of a stalactite with a length and a radius of the tip.
double root_radius(const field::StalactiteCurve& curve, double length, double tip);

struct StalactiteGrowth {
  double length = 0;  ///< Metres.
  double calcium =
      0;  ///< Calcium of the drops that fall from it, mol/m3: it consists of their loss.
};

/// The tip grows like a stalagmite, but drops that follow fast upon each other fall before they
/// have deposited much; and a stalactite takes at most a share of the water's excess of calcium at
/// any time. The length, and the calcium that has passed, increase continuously with the age.
StalactiteGrowth grow_stalactite(const Water& water, double interval,
                                 const field::StalactiteCurve& curve);

/// The length in metres of a straw that approaches its greatest length `longest`.
double straw_length(const Water& water, double interval, double longest);

/// The growth of a stalactite or a straw, and of the stalagmite below it, at a drip.
struct DripGrowth {
  double interval = 60;           ///< Seconds between drops.
  std::optional<double> straw{};  ///< The greatest length of a straw; none: a stalactite.
  const field::StalactiteCurve* curve = nullptr;  ///< That of the cave, see common_curve.

  /// With the water that arrives at the drip.
  StalactiteGrowth hanging(const Water& water) const;
  double standing_height(const Water& water) const;
};

/// When and where stalactite and stalagmite met.
struct Meeting {
  double share = 0;   ///< The age at the meeting over the present age.
  double height = 0;  ///< The height of the stalagmite then, metres.
};

/// The meeting of both over a gap in metres, if the water has flowed long enough for it.
std::optional<Meeting> meeting_of(const DripGrowth& growth, const Water& water, double gap);

}  // namespace vug::drips

// SPDX-License-Identifier: Apache-2.0
// The growth of stalactites and stalagmites from the water of their drip.
#pragma once

#include <vug/drips/graph.h>
#include <vug/field/speleothems/stalactite_curve.h>

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
/// have deposited much; and a stalactite is not larger than most of the water's excess of calcium.
StalactiteGrowth grow_stalactite(const Water& water, double interval,
                                 const field::StalactiteCurve& curve);

}  // namespace vug::drips

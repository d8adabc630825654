// SPDX-License-Identifier: Apache-2.0
// Balls at rest in a round bowl.
#pragma once

#include <vug/base/rng.h>
#include <vug/field/speleothems/lobe.h>

#include <vector>

namespace vug::field {

/// A bowl whose inside is a part of a sphere, with its lowest point at the origin.
struct PearlBowl {
  double mouth = 0.1;   ///< Radius of the rim, metres.
  double depth = 0.04;  ///< The lowest point is this far below the rim, metres; at most the mouth.

  /// Radius of the sphere.
  double curvature() const { return (mouth * mouth + depth * depth) / (2 * depth); }
};

/// Balls of these radii, dropped one after the other into the bowl, from where each rolls down to
/// rest on the bowl and on earlier balls. No two overlap, and all keep inside the bowl; a ball
/// whose middle would rest above the rim is omitted. Radii are smaller than half of the mouth.
std::vector<Lobe> packed_pearls(const PearlBowl& bowl, const std::vector<double>& radii,
                                RandomStream& random);

}  // namespace vug::field

// SPDX-License-Identifier: Apache-2.0
// Poses from which a photographer would try a picture.
#pragma once

#include <vug/base/rng.h>
#include <vug/scout/gates.h>
#include <vug/scout/pose.h>
#include <vug/scout/walk.h>

namespace vug::scout {

/// The kinds of shots. A sheet has several of them.
enum class Framing { normal, wide, low, close, up };

struct Candidate {
  Pose pose;
  Framing framing = Framing::normal;
};

/// The gates of a framing: a close shot may have a near foreground, and a view upwards no floor.
GateLimits limits_of(Framing framing);

/// A point of interest, such as the middle of a figure or of a pool.
struct Subject {
  Vec3d position;
  double size = 1;  ///< Diameter in metres.
};

/// At most `places` places to stand, spread over the floor, with four to six poses each: along the
/// directions with the longest views, 25 degrees to their sides, and towards visible subjects. The
/// eye is 1.6 m above the floor, 0.7 m in a low shot or below a low ceiling. The order and all
/// choices depend on the key only.
std::vector<Candidate> candidates(const render::PreparedScene& world,
                                  const std::vector<Stand>& floor,
                                  const std::vector<Subject>& subjects, RandomKey key,
                                  size_t places = 60);

}  // namespace vug::scout

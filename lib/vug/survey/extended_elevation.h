// SPDX-License-Identifier: Apache-2.0
// The unfolding of a survey to an extended elevation.
#pragma once

#include <vug/survey/survey.h>

#include <array>
#include <vector>

namespace vug::survey {

/// A leg in the drawing: the horizontal coordinate and the altitude of both ends, in metres.
struct ElevationLeg {
  int leg = 0;  ///< Index in Survey::legs.
  std::array<Vec2d, 2> ends;
  /// The station at both ends: of those that are equated the entrance, else the first.
  std::array<int, 2> stations{};
  bool cut = false;  ///< The second end is elsewhere in the drawing, too.
};

/// Every leg but splays once. Components are next to each other.
std::vector<ElevationLeg> extend_elevation(const Survey& survey);

}  // namespace vug::survey

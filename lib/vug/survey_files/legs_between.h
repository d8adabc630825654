// SPDX-License-Identifier: Apache-2.0
// The legs of a survey by their stations, for formats that refer to legs by their ends.
#pragma once

#include <vug/survey/survey.h>

#include <algorithm>
#include <map>
#include <utility>

namespace vug::survey {

class LegsBetween {
 public:
  explicit LegsBetween(const std::vector<Leg>& legs) {
    for (size_t i = 0; i < legs.size(); ++i)
      legs_.emplace(std::minmax(legs[i].from, legs[i].to), static_cast<int>(i));
  }

  /// The index of a leg in either direction that was not taken before; -1 if there is none.
  int take(int a, int b) {
    const auto found = legs_.find(std::minmax(a, b));
    if (found == legs_.end()) return -1;
    const int leg = found->second;
    legs_.erase(found);
    return leg;
  }

 private:
  std::multimap<std::pair<int, int>, int> legs_;
};

}  // namespace vug::survey

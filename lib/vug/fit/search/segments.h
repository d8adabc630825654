// SPDX-License-Identifier: Apache-2.0
// The best disjoint segments along a line, by dynamic programming.
#pragma once

#include <vector>

namespace vug::fit {

struct Segment {
  int start = 0, end = 0;  ///< Positions start <= i < end.
  int size() const { return end - start; }
  bool operator==(const Segment&) const = default;
};

struct SegmentLimits {
  int min_size = 1, max_size = 1;  ///< Size of a segment.
  int max_count = 16;              ///< Number of segments.
  double cost = 0;                 ///< Cost per segment.
};

/// The segments with the largest gain minus costs, in order and separated by at least one position;
/// empty if no segment gains. `before` holds prefix sums: `before[i]` is the gain of all positions
/// before i, so it has one entry more than there are positions. Time: positions x max_count.
std::vector<Segment> best_segments(const std::vector<double>& before, const SegmentLimits& limits);

}  // namespace vug::fit

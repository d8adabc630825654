// The best disjoint segments along a line, by dynamic programming.
#pragma once

#include <vector>

namespace vug::fit {

struct Segment {
  int start = 0, end = 0;  ///< Places start <= i < end.
  int size() const { return end - start; }
  bool operator==(const Segment&) const = default;
};

struct SegmentLimits {
  int min_size = 1, max_size = 1;  ///< Of a segment.
  int max_count = 16;              ///< How many.
  double cost = 0;                 ///< Of each.
};

/// `before[i]` is what all places before i gain, so there is one more than places. The segments, at
/// least a place apart and in order, that gain most less their costs; none where none gains.
/// Time: places x most.
std::vector<Segment> best_segments(const std::vector<double>& before, const SegmentLimits& limits);

}  // namespace vug::fit

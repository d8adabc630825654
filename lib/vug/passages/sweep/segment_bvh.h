// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: a bounding volume hierarchy over the axes of segments, which finds the
// segments whose values can matter near a point.
#pragma once

#include <vug/passages/sweep/segment.h>

#include <cstdint>
#include <vector>

namespace vug::passages {

class SegmentBvh {
 public:
  /// Refers to the segments and their capsules, which must outlive it.
  SegmentBvh(const std::vector<Segment>& segments, const std::vector<Capsule>& capsules);

  /// The least value of any segment at a point, and the segment that has it.
  struct Nearest {
    double value = kInfinity;
    uint32_t segment = 0;
  };
  Nearest nearest(const Vec3d& p) const;
  /// Appends the indices of segments whose value at p can be at most `limit`, in ascending order,
  /// from their distances to the axis alone. Returns false, with an incomplete list, beyond `most`
  /// segments.
  bool collect(const Vec3d& p, double limit, size_t most, std::vector<uint32_t>& out) const;

 private:
  struct Node {
    Box3d box;                      // Around the axes.
    double reach = 0;               // The largest, below the node.
    double scale = 1;               // The smallest.
    uint32_t left = 0;              // Index of the left child, whose sibling follows; 0 for a leaf.
    uint32_t first = 0, count = 0;  // Of the segments of a leaf, in order_.
    double least(const Vec3d& p) const;
  };
  void build(uint32_t node, uint32_t first, uint32_t count);

  const std::vector<Segment>& segments_;
  const std::vector<Capsule>& capsules_;
  std::vector<Node> nodes_;
  std::vector<uint32_t> order_;
};

}  // namespace vug::passages

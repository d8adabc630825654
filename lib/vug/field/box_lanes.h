// SPDX-License-Identifier: Apache-2.0
// The boxes of many solids in single precision, for batches of points: they exclude most solids
// without an evaluation.
#pragma once

#include <vug/field/node.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace vug::field {

class BoxLanes {
 public:
  static constexpr int kMostPoints = 64;

  void reserve(size_t count) { lanes_.reserve((count + kLanes - 1) / kLanes); }
  /// A solid whose values outside of its box are at least `growth` times the distance from it, and
  /// inside at least -depth. Nothing is known of its values if `growth` is 0.
  void add(const Box3d& box, double growth, double depth);
  bool empty() const { return count_ == 0; }

  /// The solid with bounds whose box is nearest to a point, as a guess of the nearest solid;
  /// nothing if none has bounds.
  std::optional<size_t> nearest(const Vec3d& p) const;
  /// Appends the solids whose values within the ball may be at most `limit`, in order.
  void find_candidates(const Ball& ball, double limit, std::vector<uint32_t>& out) const;
  /// Sets bit k of masks[i] if a value of solid i at one of the points[k] may be below one of the
  /// limits there. `count` is at most kMostPoints; there is a mask for each solid.
  void find_candidates(const Point<Pack>* points, const Pack* limits, int count,
                       uint64_t* masks) const;
  /// True if none of the values of solid i at the points is below its limit.
  bool above(size_t i, const Point<Pack>& p, const Pack& limit) const;

 private:
  static constexpr size_t kLanes = Pack::kLanes;
  /// Eight solids, or the boxes around eight solids each.
  struct Lanes {
    float low[3][kLanes], high[3][kLanes];
    float growth[kLanes], depth[kLanes], margin[kLanes];
  };
  /// A box of points, around which distances may be shorter by `nearer`.
  struct Region {
    float least[3], greatest[3], nearer = 0;
  };
  static Pack bound(const Lanes& lanes, const Region& region);
  /// Calls visit(i) for the solids whose values in the region may be at most `limit`, in order.
  template <class Visit>
  void visit_candidates(const Region& region, const Pack& limit, const Visit& visit) const;

  std::vector<Lanes> lanes_, groups_;
  size_t count_ = 0;
};

}  // namespace vug::field

// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the minimum over the segments of an active set at a batch of points.
#pragma once

#include <vug/field/node.h>
#include <vug/passages/sweep/active_set.h>

#include <algorithm>

namespace vug::passages {

inline const Pack& value_of(const Pack& x) { return x; }
inline const Pack& value_of(const Dual<Pack>& x) { return x.v; }

/// A ball around all points of a batch.
inline field::Ball ball_around(const Point<Pack>* points, size_t count) {
  Pack low[3] = {points[0].x, points[0].y, points[0].z}, high[3] = {low[0], low[1], low[2]};
  for (size_t i = 1; i < count; ++i) {
    const Pack at[3] = {points[i].x, points[i].y, points[i].z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = min(low[axis], at[axis]);
      high[axis] = max(high[axis], at[axis]);
    }
  }
  Vec3d least, most;
  for (int axis = 0; axis < 3; ++axis) {
    float lanes[Pack::kLanes];
    low[axis].store(lanes);
    least[axis] = static_cast<double>(*std::min_element(lanes, lanes + Pack::kLanes));
    high[axis].store(lanes);
    most[axis] = static_cast<double>(*std::max_element(lanes, lanes + Pack::kLanes));
  }
  return {0.5 * (least + most), 0.5 * (most - least).length()};
}

/// The minimum of a batch. The segment that is nearest to its middle is the first; others are left
/// out if their lower bound is above all values so far. Packs of points at which a segment cannot
/// be the minimum, nor within the radius of a joint above it, are left out of its evaluation.
template <class T>
class BatchMinimum {
 public:
  BatchMinimum(const SweepParts& parts, const ActiveSet& set, const Point<Pack>* points, int count,
               field::Scratch& scratch)
      : parts_(parts),
        set_(set),
        points_(points),
        count_(static_cast<size_t>(count)),
        scratch_(scratch),
        frame_(scratch),
        near_(frame_.template take<Point<Pack>>(count_)),
        values_(frame_.template take<T>(count_)),
        arms_(frame_.template take<T>(count_ * set.arms)),
        index_(frame_.template take<uint32_t>(count_)),
        lower_(frame_.template take<double>(set.segments.size())) {
    for (size_t k = 0; k < count_ * set.arms; ++k) arms_[k] = T(kFar);
    for (const Joint& joint : set.joints) reach_ = std::max(reach_, joint.radius);
  }

  void run(T* out) {
    const size_t first = find_lower_bounds();
    segment(first).fill(points_, static_cast<int>(count_), out, scratch_);
    for (size_t k = 0; k < count_; ++k) {
      index_[k] = static_cast<uint32_t>(k);
      values_[k] = out[k];
    }
    combine(first, count_, out);
    const double most = highest(out) + reach_;
    for (size_t i = 0; i < set_.segments.size(); ++i) {
      if (i == first || lower_[i] > most) continue;
      const size_t kept = keep_near(segment(i), out);
      if (kept == 0) continue;
      segment(i).fill(near_, static_cast<int>(kept), values_, scratch_);
      combine(i, kept, out);
    }
    for (const Joint& joint : set_.joints) {
      const field::Blend blend{field::Profile::smooth, joint.radius};
      for (size_t k = 0; k < count_; ++k)
        out[k] = min(out[k], blend.smin(arms_[count_ * joint.a + k], arms_[count_ * joint.b + k]));
    }
  }

 private:
  /// Fills `lower_` for a ball around the points; returns the segment nearest to its centre.
  size_t find_lower_bounds() {
    const field::Ball ball = ball_around(points_, count_);
    size_t nearest = 0;
    for (size_t i = 0; i < set_.segments.size(); ++i) {
      lower_[i] = segment(i).least(segment(i).distance_to_axis(ball.centre));
      if (lower_[i] < lower_[nearest]) nearest = i;
    }
    const double rounding = 1e-5 * (1 + ball.centre.length() * 0.1 + ball.radius);
    for (size_t i = 0; i < set_.segments.size(); ++i) lower_[i] -= ball.radius + rounding;
    return nearest;
  }

  double highest(const T* out) const {
    Pack most = value_of(out[0]);
    for (size_t k = 1; k < count_; ++k) most = max(most, value_of(out[k]));
    float lanes[Pack::kLanes];
    most.store(lanes);
    return static_cast<double>(*std::max_element(lanes, lanes + Pack::kLanes));
  }

  const Segment& segment(size_t i) const { return parts_.sweep.segments[set_.segments[i]]; }

  size_t keep_near(const Segment& segment, const T* out) {
    const Pack margin(reach_ + 1e-4 * segment.reach());
    size_t kept = 0;
    for (size_t k = 0; k < count_; ++k) {
      if (!any(segment.least(points_[k]) < value_of(out[k]) + margin)) continue;
      near_[kept] = points_[k];
      index_[kept++] = static_cast<uint32_t>(k);
    }
    return kept;
  }

  void combine(size_t i, size_t kept, T* out) {
    for (size_t k = 0; k < kept; ++k) out[index_[k]] = min(out[index_[k]], values_[k]);
    const auto before = [](const ActiveSet::Link& link, size_t at) { return link.segment < at; };
    auto link = std::lower_bound(set_.links.begin(), set_.links.end(), i, before);
    for (; link != set_.links.end() && link->segment == i; ++link) {
      T* arm = arms_ + count_ * link->arm;
      for (size_t k = 0; k < kept; ++k) arm[index_[k]] = min(arm[index_[k]], values_[k]);
    }
  }

  const SweepParts& parts_;
  const ActiveSet& set_;
  const Point<Pack>* points_;
  size_t count_;
  field::Scratch& scratch_;
  field::Scratch::Frame frame_;
  Point<Pack>* near_;
  T* values_;
  T* arms_;
  uint32_t* index_;
  double* lower_;  // A lower bound of each segment's values.
  double reach_ = 0;
};

}  // namespace vug::passages

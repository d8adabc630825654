// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the minimum over the segments of an active set at a batch of points.
#pragma once

#include <vug/passages/sweep/active_set.h>

#include <algorithm>

namespace vug::passages {

inline const Pack& value_of(const Pack& x) { return x; }
inline const Pack& value_of(const Dual<Pack>& x) { return x.v; }

/// The segment whose axis is nearest to the first point of a pack; its values bound the others.
inline size_t nearest_segment(const SweepParts& parts, const ActiveSet& set, const Point<Pack>& p) {
  float x[Pack::kLanes], y[Pack::kLanes], z[Pack::kLanes];
  p.x.store(x);
  p.y.store(y);
  p.z.store(z);
  const Vec3d at(Vec3f(x[0], y[0], z[0]));
  size_t nearest = 0;
  double least = kInfinity;
  for (size_t i = 0; i < set.segments.size(); ++i) {
    const Segment& segment = parts.sweep.segments[set.segments[i]];
    const double value = segment.least(segment.distance_to_axis(at));
    if (value >= least) continue;
    least = value;
    nearest = i;
  }
  return nearest;
}

/// The minimum of a batch. Packs of points at which a segment cannot be the minimum, nor within the
/// radius of a joint above it, are left out of its evaluation.
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
        index_(frame_.template take<uint32_t>(count_)) {
    for (size_t k = 0; k < count_ * set.arms; ++k) arms_[k] = T(kFar);
    for (const Joint& joint : set.joints) reach_ = std::max(reach_, joint.radius);
  }

  void run(T* out) {
    const size_t first = nearest_segment(parts_, set_, points_[count_ / 2]);
    segment(first).fill(points_, static_cast<int>(count_), out, scratch_);
    for (size_t k = 0; k < count_; ++k) {
      index_[k] = static_cast<uint32_t>(k);
      values_[k] = out[k];
    }
    combine(first, count_, out);
    for (size_t i = 0; i < set_.segments.size(); ++i) {
      if (i == first) continue;
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
  double reach_ = 0;
};

}  // namespace vug::passages

// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the minimum over the segments of an active set at a batch of points.
#pragma once

#include <vug/field/numbers/value_of.h>
#include <vug/passages/sweep/active_set.h>
#include <vug/passages/sweep/batch_box.h>

#include <algorithm>
#include <limits>

namespace vug::passages {

using field::value_of;

/// The minimum of a batch. The segment that is nearest to its middle is the first; the others
/// follow in the order of their lower bounds, until these are above all values so far. Packs of
/// points at which a segment cannot be the minimum, nor within the radius of a joint above it, are
/// left out of its evaluation.
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
        least_(frame_.template take<Pack>(count_)),
        values_(frame_.template take<T>(count_)),
        arms_(frame_.template take<T>(count_ * set.arms)),
        index_(frame_.template take<uint32_t>(count_)),
        others_(frame_.template take<Bound>(set.segments.size())) {
    for (size_t k = 0; k < count_ * set.arms; ++k) arms_[k] = T(kFar);
    for (const Joint& joint : set.joints) widest_ = std::max(widest_, joint.radius);
  }

  void run(T* out) {
    const size_t first = find_lower_bounds();
    segment(first).fill(points_, static_cast<int>(count_), out, scratch_);
    for (size_t k = 0; k < count_; ++k) {
      index_[k] = static_cast<uint32_t>(k);
      values_[k] = out[k];
    }
    combine(first, count_, out);
    double most = highest_of(out);
    const auto end = std::partition(others_, others_ + set_.segments.size(), [&](const Bound& b) {
      return b.segment != first && b.least <= most;
    });
    std::sort(others_, end);
    for (const Bound* other = others_; other != end && other->least <= most; ++other) {
      const size_t kept = keep_near(segment(other->segment), other->fillet, out);
      if (kept == 0) continue;
      segment(other->segment).fill(near_, static_cast<int>(kept), values_, scratch_);
      combine(other->segment, kept, out);
      most = highest_of(out);
    }
    for (const Joint& joint : set_.joints) {
      const field::Blend blend{field::Profile::smooth, joint.radius};
      for (size_t k = 0; k < count_; ++k)
        out[k] = min(out[k], blend.smin(arms_[count_ * joint.a + k], arms_[count_ * joint.b + k]));
    }
  }

 private:
  /// A lower bound of a segment's values at the points, less the radius of its joints.
  struct Bound {
    double least;
    double fillet;
    uint32_t segment;
    bool operator<(const Bound& other) const {  // A total order.
      return least < other.least || (least == other.least && segment < other.segment);
    }
  };

  /// Fills `others_`; returns the segment nearest to the middle. The plane across the offset of the
  /// middle from the axis bounds the distances of a box from the axis.
  size_t find_lower_bounds() {
    using field::max;
    const BatchBox box = box_around(points_, count_);
    const Point<Pack> centre = field::constant<Pack>(box.centre),
                      half = field::constant<Pack>(box.half);
    const Pack rounding(1e-5 * (1 + box.centre.length() * 0.1 + box.half.length())),
        widest(widest_);
    float nearest = std::numeric_limits<float>::max();
    size_t first = 0;
    for (size_t begin = 0; begin < set_.segments.size(); begin += Pack::kLanes) {
      const CapsulePack capsule = set_.capsules.pack(begin / Pack::kLanes);
      const Point<Pack> offset = capsule.offset(centre);
      const Pack distance = field::length(offset),
                 depth = dot(abs(offset), half) / max(distance, Pack(1e-18)),
                 fillet = min(capsule.fillet, widest);
      float middle[Pack::kLanes], least[Pack::kLanes], fillets[Pack::kLanes];
      capsule.least_at(distance).store(middle);
      (capsule.least_at(distance - depth) - rounding - fillet).store(least);
      fillet.store(fillets);
      const size_t end = std::min(begin + Pack::kLanes, set_.segments.size());
      for (size_t i = begin; i < end; ++i) {
        const size_t lane = i - begin;
        others_[i] = {static_cast<double>(least[lane]), static_cast<double>(fillets[lane]),
                      static_cast<uint32_t>(i)};
        if (middle[lane] < nearest) {
          nearest = middle[lane];
          first = i;
        }
      }
    }
    return first;
  }

  double highest_of(const T* out) const {
    Pack most = value_of(out[0]);
    for (size_t k = 1; k < count_; ++k) most = max(most, value_of(out[k]));
    return static_cast<double>(highest(most));
  }

  const Segment& segment(size_t i) const { return parts_.sweep.segments[set_.segments[i]]; }

  size_t keep_near(const Segment& segment, double fillet, const T* out) {
    const Pack margin(fillet + 1e-4 * segment.reach());
    segment.least(points_, count_, least_);
    size_t kept = 0;
    for (size_t k = 0; k < count_; ++k) {
      if (!any(least_[k] < value_of(out[k]) + margin)) continue;
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
  Pack* least_;
  T* values_;
  T* arms_;
  uint32_t* index_;
  Bound* others_;
  double widest_ = 0;
};

}  // namespace vug::passages

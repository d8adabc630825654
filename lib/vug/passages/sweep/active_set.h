// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the segments, arms and joints that matter in a region, and their minimum.
#pragma once

#include <vug/field/blend.h>
#include <vug/passages/sweep/capsule_list.h>
#include <vug/passages/sweep/segment_bvh.h>
#include <vug/passages/sweep/sweep.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace vug::passages {

/// A list of segments with what their bounds need. Arms and joints are numbered anew, 0 .. arms -
/// 1; a joint is kept if both of its arms are.
struct ActiveSet {
  struct Link {
    uint32_t segment;  ///< Index in `segments`.
    uint32_t arm;
  };
  std::vector<uint32_t> segments;  ///< Indices in the sweep, ascending.
  CapsuleList capsules;            ///< One for each segment.
  std::vector<Link> links;         ///< In the order of the segments.
  std::vector<Joint> joints;
  uint32_t arms = 0;

  void clear() {
    segments.clear();
    capsules.clear();
  }
  void reserve(size_t size) {
    segments.reserve(size);
    capsules.reserve(size);
  }
  /// Appends segments of another set: the lanes of a pack of its capsules whose bits are set.
  void append(const ActiveSet& other, size_t pack, unsigned lanes) {
    capsules.append(other.capsules, pack, lanes);
    for (; lanes != 0; lanes &= lanes - 1)
      segments.push_back(
          other.segments[Pack::kLanes * pack + static_cast<size_t>(std::countr_zero(lanes))]);
  }
};

/// The parts of a sweep with the links from segments to arms and from arms to joints. Immutable.
struct SweepParts {
  explicit SweepParts(Sweep parts);
  SweepParts(const SweepParts&) = delete;
  SweepParts& operator=(const SweepParts&) = delete;

  Sweep sweep;
  std::vector<Capsule> capsules;  ///< One for each segment.
  ActiveSet all;                  ///< All segments, without links.
  std::vector<std::vector<uint32_t>> arms_of_segment;
  std::vector<std::vector<uint32_t>> joints_of_arm;
  double widest_joint = 0;
  SegmentBvh bvh;
};

/// Fills the links and joints of `set`, whose segments and capsules are given.
void link(const SweepParts& parts, ActiveSet& set);

/// Fills the capsules of `set`, whose segments are given.
void fill_capsules(const SweepParts& parts, ActiveSet& set);

/// Fills the rest of `set`, whose segments are given.
void complete(const SweepParts& parts, ActiveSet& set);

/// A value above all values of segments.
inline constexpr double kFar = 1e30;

/// The field of the set, given the values of segments in order: combine(i, value) and finish().
/// Segments that cannot matter may be left out.
template <class T>
class Minimum {
 public:
  /// `arms` has room for set.arms numbers.
  Minimum(const ActiveSet& set, T* arms) : set_(set), arms_(arms) {
    for (uint32_t i = 0; i < set.arms; ++i) arms_[i] = T(kFar);
  }
  void combine(size_t segment, const T& value) {
    using field::min;
    least_ = segment == 0 ? value : T(min(least_, value));
    while (next_ < set_.links.size() && set_.links[next_].segment < segment) ++next_;
    for (; next_ < set_.links.size() && set_.links[next_].segment == segment; ++next_) {
      T& arm = arms_[set_.links[next_].arm];
      arm = min(arm, value);
    }
  }
  T finish() const {
    using field::min;
    T out = least_;
    for (const Joint& joint : set_.joints)
      out = min(out, field::Blend{field::Profile::smooth, joint.radius}.smin(arms_[joint.a],
                                                                             arms_[joint.b]));
    return out;
  }

 private:
  const ActiveSet& set_;
  T* arms_;
  T least_{kFar};
  size_t next_ = 0;
};

}  // namespace vug::passages

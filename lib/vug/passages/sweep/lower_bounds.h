// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: lower bounds of the values of an active set's segments at a point, for the
// selection of those that matter around it.
#pragma once

#include <vug/passages/sweep/block_minimum.h>

#include <algorithm>
#include <bit>

namespace vug::passages {

/// A joint has no effect where the values of its arms differ by more than its radius. Therefore a
/// segment matters where its value is at most the minimum plus the radius of its own joints.
/// Refers to the set; at most one object at a time in each thread.
class LowerBounds {
 public:
  LowerBounds(const ActiveSet& set, const Vec3d& p) : set_(set) {
    const Point<Pack> at = field::constant<Pack>(p);
    const Pack rounding(CapsulePack::kRounding * p.length());
    bounds_.resize(set.capsules.packs());
    for (size_t k = 0; k < bounds_.size(); ++k) {
      const CapsulePack capsule = set.capsules.pack(k);
      bounds_[k] = capsule.least_at(field::length(capsule.offset(at))) - rounding;
    }
  }

  /// The index of the segment with the lowest bound.
  size_t nearest() const {
    const auto* bounds = reinterpret_cast<const float*>(bounds_.data());
    return static_cast<size_t>(std::min_element(bounds, bounds + set_.segments.size()) - bounds);
  }
  double bound(size_t segment) const {
    return static_cast<double>(reinterpret_cast<const float*>(bounds_.data())[segment]);
  }
  /// The number of segments that can matter where the minimum is at most `limit`.
  size_t count_below(double limit) const { return count(limit, 1); }
  /// Appends these segments.
  void append_below(double limit, ActiveSet& out) const { append(limit, 1, out); }
  /// The number of segments that can matter where the field is at most `limit`.
  size_t count_near(double limit) const { return count(limit, limit_with_fillet(0, 1)); }
  /// Appends these segments.
  void append_near(double limit, ActiveSet& out) const {
    append(limit, limit_with_fillet(0, 1), out);
  }

 private:
  /// Segments whose bound is at most `limit` plus `fillets` times the radius of their joints.
  unsigned below(size_t k, double limit, double fillets) const {
    return bits_of(bounds_[k] <= set_.capsules.fillets(k) * Pack(fillets) + Pack(limit));
  }
  size_t count(double limit, double fillets) const {
    size_t count = 0;
    for (size_t k = 0; k < bounds_.size(); ++k)
      count += static_cast<size_t>(std::popcount(below(k, limit, fillets)));
    return count;
  }
  void append(double limit, double fillets, ActiveSet& out) const {
    for (size_t k = 0; k < bounds_.size(); ++k)
      if (const unsigned lanes = below(k, limit, fillets)) out.append(set_, k, lanes);
  }
  static std::vector<Pack>& memory() {
    thread_local std::vector<Pack> bounds;
    return bounds;
  }

  const ActiveSet& set_;
  std::vector<Pack>& bounds_ = memory();
};

}  // namespace vug::passages

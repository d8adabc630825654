// SPDX-License-Identifier: Apache-2.0
// The capsules of a list of segments, eight at a time in single precision,
// for bounds from one point.
#pragma once

#include <vug/field/numbers/pack.h>
#include <vug/field/point.h>
#include <vug/passages/sweep/capsule.h>

#include <cstdint>
#include <vector>

namespace vug::passages {

using field::Pack, field::Point;

/// One bit for each lane.
inline unsigned bits_of(field::PackMask lanes) {
  return static_cast<unsigned>(_mm256_movemask_ps(lanes.bits));
}

/// Eight capsules. Their reach includes the rounding of the conversion and of the formulas below,
/// up to kRounding times the distance of the point from the origin.
struct CapsulePack {
  static constexpr double kRounding = 1e-6;

  Point<Pack> start, along;
  Pack length, reach, scale;
  Pack fillet;  ///< Radius of the widest joint of the segment's arms, or 0.

  /// The offsets of a point from the nearest points of the axes.
  Point<Pack> offset(const Point<Pack>& p) const {
    const Point<Pack> from = p - start;
    return from - along * field::clamp(dot(from, along), Pack(0.0), length);
  }
  /// Lower bounds of the values at these distances from the axes; see Capsule::least_at.
  Pack least_at(const Pack& distance) const {
    const Pack away = distance * Pack(1 - kRounding) - reach;
    return min(away, scale * away);
  }
};

/// A list of capsules as one array for each number, in the order of CapsulePack. Lanes of the last
/// pack beyond the size have no inside.
class CapsuleList {
 public:
  void clear() { size_ = 0; }
  void reserve(size_t size);
  void append(const Capsule& capsule, double fillet);
  void append(const CapsuleList& other, size_t index) {
    append(other, index / Pack::kLanes, 1u << index % Pack::kLanes);
  }
  /// Appends the lanes of a pack whose bits are set.
  void append(const CapsuleList& other, size_t pack, unsigned lanes);

  size_t size() const { return size_; }
  size_t packs() const { return (size_ + Pack::kLanes - 1) / Pack::kLanes; }
  CapsulePack pack(size_t k) const {
    return {{load(0, k), load(1, k), load(2, k)},
            {load(3, k), load(4, k), load(5, k)},
            load(6, k),
            load(kReach, k),
            load(kScale, k),
            load(kFillet, k)};
  }
  Pack fillets(size_t pack) const { return load(kFillet, pack); }

 private:
  static constexpr size_t kReach = 7, kScale = 8, kFillet = 9, kNumbers = 10;
  Pack load(size_t number, size_t pack) const {
    return Pack::load(numbers_.data() + number * stride_ + Pack::kLanes * pack);
  }
  void make_room(size_t more);
  void end();

  std::vector<float> numbers_;
  size_t size_ = 0;
  size_t stride_ = 0;  // At least size_ + 8, or 0.
};

}  // namespace vug::passages

// SPDX-License-Identifier: Apache-2.0
// The free and consumed bonds of a growing base.
#pragma once

#include <vug/sgm/shape.h>

#include <functional>

namespace vug::sgm {

struct PooledBond {
  Bond bond;
  int id;  ///< Unique within the pool.
};

class BondPool {
 public:
  /// Adds free bonds, except where a shape was joined before (within 1e-6 of `size`, metres).
  void add(const std::vector<Bond>& bonds, double size);

  /// Takes a free bond of the side, selected by `key` if there are several; directed bonds take
  /// precedence over D = 0. For a side without a free bond it returns the bond that bond_on
  /// computes from `base`, or support_bond if that one is already consumed, or nothing if both are.
  std::optional<PooledBond> take(Label side, const field::Field& base, RandomKey key);
  void release(const PooledBond& bond) { free_.push_back(bond); }
  /// Records that a shape was joined here, so that no other one is.
  void consume(const Bond& bond) { consumed_.push_back(bond); }

  /// Moves the bonds for which `touched` holds back onto the surface of `base`, along their own
  /// line and at most `depth` metres inwards. Bonds that miss the surface or meet another bond are
  /// dropped.
  void reproject(const field::Field& base, double depth,
                 const std::function<bool(const Bond&)>& touched);

  std::vector<Bond> free() const;

 private:
  bool taken(const Bond& bond, double size) const;

  std::vector<PooledBond> free_;
  std::vector<Bond> consumed_;
  int next_id_ = 0;
};

/// The bond at which its line, coming from outside, first meets a wall of `base` that is at least
/// `thickness` metres thick, at most `depth` metres below the old point, or nothing. Thinner walls
/// are remnants of a cut and unsuitable for joining.
std::optional<Bond> recast(const Bond& bond, const field::Field& base, double depth,
                           double thickness = 0);

}  // namespace vug::sgm

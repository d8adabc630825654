// The bonds of a growing base: which are free, which are consumed, and where they went.
#pragma once

#include <vug/sgm/shape.h>

#include <functional>

namespace vug::sgm {

struct PooledBond {
  Bond bond;
  int id;  ///< Never given twice.
};

class BondPool {
 public:
  /// Adds free bonds, except where a shape was joined before (within 1e-6 of `size`, metres).
  void add(const std::vector<Bond>& bonds, double size);

  /// Takes a free bond of the side, one of several by `key`; directed ones come before D = 0.
  /// A side without one gets the bond that bond_on computes from `base`, or support_bond where
  /// that one is consumed already. Nothing when both are.
  std::optional<PooledBond> take(Label side, const field::Field& base, RandomKey key);
  void release(const PooledBond& bond) { free_.push_back(bond); }
  /// Remembers that a shape was joined here, so that none is again.
  void consume(const Bond& bond) { consumed_.push_back(bond); }

  /// Brings the bonds for which `touched` holds back to the surface of `base`, along their
  /// own line and at most `depth` metres inwards; those that find none, or meet another bond,
  /// are dropped.
  void reproject(const field::Field& base, double depth,
                 const std::function<bool(const Bond&)>& touched);

  std::vector<Bond> free() const;

 private:
  bool taken(const Bond& bond, double size) const;

  std::vector<PooledBond> free_;
  std::vector<Bond> consumed_;
  int next_id_ = 0;
};

/// The bond where its line, coming from outside, first meets a wall of `base` that is at least
/// `thickness` metres thick, at most `depth` metres below the old point; nothing when it does
/// not. Thinner walls are crumbs of a cut, which nothing should hang on.
std::optional<Bond> recast(const Bond& bond, const field::Field& base, double depth,
                           double thickness = 0);

}  // namespace vug::sgm

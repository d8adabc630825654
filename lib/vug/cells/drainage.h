// SPDX-License-Identifier: Apache-2.0
// The steady flow of water over a network: from each cell to its lower neighbours, through pools
// and over their crests to the outlets.
#pragma once

#include <vug/base/vec.h>
#include <vug/cells/links.h>

#include <cstdint>
#include <span>
#include <vector>

namespace vug::cells {

/// Water and the calcium that it carries, per second.
struct Load {
  double water = 0;    ///< m3/s.
  double calcium = 0;  ///< mol/s.
};

struct DrainageOptions {
  int gather = 4;      ///< Exponent of the steepness in a lower neighbour's share (freeman1991).
  double head = 5e-4;  ///< Crests up to this height above a pool's level overflow, metres.
};

class Drainage {
 public:
  static constexpr uint32_t kNone = ~0u;

  /// `position`: metres, y up; `outlet`: see find_outlets.
  Drainage(const Links& links, const std::vector<Vec3f>& position,
           const std::vector<uint8_t>& outlet, const DrainageOptions& options);

  /// Metres of water that stand on the cell; 0 outside pools.
  float depth(uint32_t cell) const { return level_[cell] - height_[cell]; }
  /// The sine of the steepest way down; 0 in pools.
  float steepness(uint32_t cell) const { return steep_[cell]; }
  /// The index of the cell's pool, or kNone. Level ground without a way down is a pool of depth 0.
  uint32_t pool(uint32_t cell) const { return pool_[cell]; }
  uint32_t pools() const { return static_cast<uint32_t>(members_.size()); }
  std::span<const uint32_t> members(uint32_t pool) const { return members_.of(pool); }

  /// Whether each piece of the network has an outlet.
  bool reaches_outlets() const;

  /// Sends water from the highest cells to the outlets. `load` contains what enters at each cell;
  /// afterwards, what arrives there in total; for the cells of a pool, all that arrives in the
  /// pool. `in_cell(cell, load)` and `in_pool(pool, load)` return what leaves. Returns the total
  /// that leaves at outlets. Sums are in a fixed order.
  template <class InCell, class InPool>
  Load route(std::vector<Load>& load, const InCell& in_cell, const InPool& in_pool) const {
    Load out;
    const auto give = [&](uint32_t to, double share, const Load& leaving) {
      load[to].water += share * leaving.water;
      load[to].calcium += share * leaving.calcium;
    };
    for (const uint64_t node : order_) {
      const auto at = static_cast<uint32_t>(node);
      if (!(at & kCell)) {
        Load all;
        for (const uint32_t cell : members_.of(at))
          all.water += load[cell].water, all.calcium += load[cell].calcium;
        for (const uint32_t cell : members_.of(at)) load[cell] = all;
        const Load leaving = in_pool(at, all);
        for (uint32_t k = crests_.begin[at]; k < crests_.begin[at + 1]; ++k)
          give(crests_.to[k], crest_share_[k], leaving);
        continue;
      }
      const uint32_t cell = at & ~kCell;
      if (!(load[cell].water > 0)) continue;
      const Load leaving = in_cell(cell, load[cell]);
      if (outlet_[cell]) {
        out.water += leaving.water, out.calcium += leaving.calcium;
        continue;
      }
      double total = 0;  // In double precision, so that nothing is lost.
      for (uint32_t k = links_.begin[cell]; k < links_.begin[cell + 1]; ++k)
        total += static_cast<double>(weight_[k]);
      for (uint32_t k = links_.begin[cell]; k < links_.begin[cell + 1]; ++k)
        if (weight_[k] > 0) give(links_.to[k], static_cast<double>(weight_[k]) / total, leaving);
    }
    return out;
  }

 private:
  static constexpr uint32_t kCell = 0x80000000u;  ///< Marks cells, as opposed to pools, in order_.

  void find_pools();
  void find_crests(double head);
  void set_weights(const std::vector<Vec3f>& position, int gather);
  void set_order();

  const Links& links_;
  const std::vector<uint8_t>& outlet_;
  std::vector<float> height_, level_, steep_;
  std::vector<uint32_t> pool_;
  Links members_;  ///< The cells of each pool.
  Links crests_;   ///< The cells over which each pool overflows.
  std::vector<double> crest_share_;
  std::vector<float> crest_of_;  ///< The level of the pool that overflows here; NaN elsewhere.
  std::vector<float> weight_;    ///< For each link, in proportion to the outflow that takes it.
  std::vector<uint64_t> order_;  ///< Pools and cells, from the highest level down.
};

}  // namespace vug::cells

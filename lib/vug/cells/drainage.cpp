// SPDX-License-Identifier: Apache-2.0
// Every cell other than an outlet has a lower neighbour or belongs to a pool, and every pool has a
// crest with a way down, because fill_pools raises levels to the lowest crest. A crest within the
// head may be above its pool; its water leaves the pool and must not return, so it only takes links
// to levels below the pool, and its turn comes after the pool's. Thus loads only move forward in
// the order of levels.
#include <vug/base/parallel.h>
#include <vug/cells/drainage.h>
#include <vug/cells/fill_pools.h>
#include <vug/cells/integer_power.h>
#include <vug/cells/level_key.h>
#include <vug/cells/network.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::cells {
namespace {

constexpr float kNoCrest = std::numeric_limits<float>::quiet_NaN();

/// Ends the last row of links under construction.
void end_row(Links& rows) { rows.begin.push_back(static_cast<uint32_t>(rows.to.size())); }

}  // namespace

Drainage::Drainage(const Links& links, const std::vector<Vec3f>& position,
                   const std::vector<uint8_t>& outlet, const DrainageOptions& options)
    : links_(links), outlet_(outlet), height_(position.size()) {
  parallel_for(
      position.size(), [&](size_t i) { height_[i] = position[i].y; }, kCellGrain);
  level_ = fill_pools(links, height_, outlet);
  find_pools();
  find_crests(options.head);
  set_weights(position, options.gather);
  set_order();
}

void Drainage::find_pools() {
  pool_.assign(height_.size(), kNone);
  std::vector<uint8_t> flat(height_.size());
  parallel_for(
      flat.size(),
      [&](size_t i) {
        const auto to = links_.of(static_cast<uint32_t>(i));
        flat[i] = !outlet_[i] && std::none_of(to.begin(), to.end(),
                                              [&](uint32_t j) { return level_[j] < level_[i]; });
      },
      kCellGrain);
  for (uint32_t i = 0; i < flat.size(); ++i) {
    if (!flat[i] || pool_[i] != kNone) continue;
    const uint32_t pool = pools();
    pool_[i] = pool;
    members_.to.push_back(i);
    for (size_t next = members_.begin.back(); next < members_.to.size(); ++next)
      for (const uint32_t j : links_.of(members_.to[next]))
        if (flat[j] && pool_[j] == kNone && level_[j] == level_[i]) {
          pool_[j] = pool;
          members_.to.push_back(j);
        }
    end_row(members_);
  }
}

void Drainage::find_crests(double head) {
  crest_of_.assign(height_.size(), kNoCrest);
  const auto drains_below = [&](uint32_t cell, float level) {
    if (outlet_[cell]) return true;
    const auto to = links_.of(cell);
    return std::any_of(to.begin(), to.end(), [&](uint32_t j) { return level_[j] < level; });
  };
  const auto level_of = [&](uint32_t pool) { return level_[members_.of(pool)[0]]; };
  Links candidates;
  for (uint32_t p = 0; p < pools(); ++p) {
    const float level = level_of(p), highest = level + static_cast<float>(head);
    const auto first = static_cast<std::ptrdiff_t>(candidates.to.size());
    for (const uint32_t cell : members_.of(p))
      for (const uint32_t j : links_.of(cell))
        if (pool_[j] == kNone && level_[j] <= highest && drains_below(j, level)) {
          candidates.to.push_back(j);
          if (!(crest_of_[j] >= level)) crest_of_[j] = level;
        }
    std::sort(candidates.to.begin() + first, candidates.to.end());
    candidates.to.erase(std::unique(candidates.to.begin() + first, candidates.to.end()),
                        candidates.to.end());
    end_row(candidates);
  }
  for (uint32_t p = 0; p < pools(); ++p) {
    const float level = level_of(p);
    double total = 0;
    for (const uint32_t j : candidates.of(p)) {
      // A crest between two pools drains the upper one.
      if (crest_of_[j] != level) continue;
      // A broad-crested weir: the flow grows with the depth over the crest to the power 3/2.
      const double over = head > 0 ? 1 - static_cast<double>(level_[j] - level) / head : 1;
      const double share = over * std::sqrt(std::max(over, 0.0)) + 1e-9;
      crests_.to.push_back(j);
      crest_share_.push_back(share);
      total += share;
    }
    for (size_t k = crests_.begin.back(); k < crests_.to.size(); ++k) crest_share_[k] /= total;
    end_row(crests_);
  }
}

bool Drainage::reaches_outlets() const {
  for (uint32_t p = 0; p < pools(); ++p)
    if (crests_.degree(p) == 0) return false;
  return true;
}

void Drainage::set_weights(const std::vector<Vec3f>& position, int gather) {
  weight_.assign(links_.to.size(), 0);
  steep_.assign(height_.size(), 0);
  parallel_for(
      height_.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        if (pool_[i] != kNone) return;
        const float below = std::isnan(crest_of_[i]) ? level_[i] : crest_of_[i];
        for (uint32_t k = links_.begin[i]; k < links_.begin[i + 1]; ++k) {
          const uint32_t to = links_.to[k];
          if (!(level_[to] < below)) continue;
          const Vec3f d = position[to] - position[i];
          // A pool's surface is nearer than its bed.
          const double drop = static_cast<double>(level_[i] - level_[to]);
          const double far = std::sqrt(static_cast<double>(d.x * d.x + d.z * d.z) + drop * drop);
          const double sine = drop / far, weight = integer_power(sine, gather);
          weight_[k] = static_cast<float>(std::max(weight, 1e-30));
          steep_[i] = std::max(steep_[i], static_cast<float>(sine));
        }
      },
      kCellGrain);
}

// Pools come before crests of the same level.
void Drainage::set_order() {
  order_.reserve(height_.size());
  for (uint32_t p = 0; p < pools(); ++p) order_.push_back(level_key(-level_[members_.of(p)[0]], p));
  for (uint32_t i = 0; i < height_.size(); ++i)
    if (pool_[i] == kNone)
      order_.push_back(
          level_key(-(std::isnan(crest_of_[i]) ? level_[i] : crest_of_[i]), i | kCell));
  sort_by_level(order_);
}

}  // namespace vug::cells

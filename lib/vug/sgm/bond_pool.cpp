// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/bond_pool.h>
#include <vug/sgm/probe.h>

#include <vug/field/boolean.h>

#include <algorithm>
#include <cmath>

namespace vug::sgm {
namespace {

constexpr double kTolerance = 1e-6;  // Relative to the size of the base, as in makes_label.

bool same(const Bond& a, const Bond& b, double size) {
  return (a.point - b.point).length() <= kTolerance * size &&
         (a.direction - b.direction).length() <= kTolerance;
}

}  // namespace

std::optional<Bond> recast(const Bond& bond, const field::Field& base, double depth,
                           double thickness) {
  const double size = size_of(base);
  const Box3d& box = base.bounds();
  const bool kept = std::fabs(base.value(bond.point)) <= kTolerance * size * base.lipschitz();
  // As far out as the farthest corner of the bounds, beyond which there is nothing.
  constexpr double kHorizon = 100;  // Metres, where the bounds are infinite.
  double out = 0;
  for (int i = 0; i < 3; ++i) {
    const double face = bond.direction[i] > 0 ? box.max[i] : box.min[i];
    if (bond.direction[i] != 0) out += std::max(0.0, bond.direction[i] * (face - bond.point[i]));
  }
  out = std::min(out + kTolerance * size, kHorizon + size);
  const Vec3d start = bond.point + bond.direction * out, inwards = -bond.direction;
  if (bond.free_direction() || base.value(start) <= 0)  // The line cannot start outside.
    return kept ? std::optional(bond) : std::nullopt;
  const field::Field air = field::complement(base);
  const double nudge = 1e-9 * size;  // Beyond the surface just found, whatever its rounding.
  for (double t = 0; t < out + depth;) {
    const auto enters = first_hit(base, start + inwards * t, inwards, out + depth - t);
    if (!enters) break;
    t += *enters;
    if (thickness <= 0) return Bond{start + inwards * t, bond.direction};
    const auto leaves = first_hit(air, start + inwards * (t + nudge), inwards, thickness);
    if (!leaves) return Bond{start + inwards * t, bond.direction};
    t += nudge + *leaves + nudge;
  }
  return std::nullopt;
}

void BondPool::add(const std::vector<Bond>& bonds, double size) {
  for (const Bond& bond : bonds)
    if (!taken(bond, size)) free_.push_back({bond, next_id_++});
}

bool BondPool::taken(const Bond& bond, double size) const {
  return std::any_of(consumed_.begin(), consumed_.end(),
                     [&](const Bond& c) { return same(c, bond, size); });
}

std::optional<PooledBond> BondPool::take(Label side, const field::Field& base, RandomKey key) {
  std::vector<size_t> directed, undirected;
  for (size_t i = 0; i < free_.size(); ++i)
    if (on_side(free_[i].bond, side))
      (free_[i].bond.free_direction() ? undirected : directed).push_back(i);
  const auto& candidates = directed.empty() ? undirected : directed;
  if (!candidates.empty()) {
    const auto pick = RandomStream(key).below(static_cast<uint32_t>(candidates.size()));
    const auto at = free_.begin() + static_cast<std::ptrdiff_t>(candidates[pick]);
    const PooledBond out = *at;
    free_.erase(at);
    return out;
  }
  const double size = size_of(base);
  std::optional<Bond> bond = bond_on(base, side);
  if (bond && taken(*bond, size)) bond = support_bond(base, side);
  if (!bond || taken(*bond, size)) return std::nullopt;
  return PooledBond{*bond, next_id_++};
}

void BondPool::reproject(const field::Field& base, double depth,
                         const std::function<bool(const Bond&)>& touched) {
  const double size = size_of(base);
  std::vector<PooledBond> kept;
  std::vector<PooledBond> moved;
  for (const PooledBond& own : free_) {
    if (!touched(own.bond)) {
      kept.push_back(own);
    } else if (const auto bond = recast(own.bond, base, depth)) {
      moved.push_back({*bond, own.id});
    }
  }
  for (const PooledBond& own : moved) {
    const bool met = std::any_of(kept.begin(), kept.end(), [&](const PooledBond& other) {
      return same(other.bond, own.bond, size);
    });
    if (!met && !taken(own.bond, size)) kept.push_back(own);
  }
  free_ = std::move(kept);
}

std::vector<Bond> BondPool::free() const {
  std::vector<Bond> out;
  for (const PooledBond& own : free_) out.push_back(own.bond);
  return out;
}

}  // namespace vug::sgm

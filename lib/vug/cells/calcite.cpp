// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/cells/calcite.h>
#include <vug/cells/frames.h>
#include <vug/cells/network.h>
#include <vug/cells/simulation.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

/// Diffusivity of calcium and bicarbonate in water, m2/s.
constexpr double kDiffusivity = 1e-9;
constexpr double kMostStretch = 3;
/// The rate of the fastest films relative to that of water at rest, less 1.
constexpr double kMostGain = 9;

/// The gain of a rate by the speed of a film, relative to `agitation`: proportional at first.
double gain(double speed) { return speed / (1 + speed / kMostGain); }

/// 1 - exp(-x), by its series for small x: as exact, and faster.
double share_lost(double x) {
  return x < 0.01 ? x * (1 - x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5)))) : 1 - maths::exp(-x);
}

}  // namespace

std::vector<float> stretch(const Pass& pass) {
  const Network& n = pass.network();
  std::vector<float> out(n.size(), 1);
  if (!pass.has("height")) return out;
  const OptionalReader height = pass.reads_optional("height", 0);
  parallel_for(
      n.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        // The gradient g of least squares: sum (d d^T) g = sum d (h_j - h_i), for tangents d.
        const auto [right, ahead] = tangents_of(n.normal[i]);
        double xx = 0, xy = 0, yy = 0, xh = 0, yh = 0;
        for (const uint32_t to : n.links.of(i)) {
          const Vec3f d = n.position[to] - n.position[i];
          const auto x = static_cast<double>(d.dot(right)), y = static_cast<double>(d.dot(ahead));
          const auto h = static_cast<double>(height[to] - height[i]);
          xx += x * x, xy += x * y, yy += y * y, xh += x * h, yh += y * h;
        }
        const double det = xx * yy - xy * xy;
        if (!(det > 1e-6 * (xx + yy) * (xx + yy))) return;
        const double gx = (yy * xh - xy * yh) / det, gy = (xx * yh - xy * xh) / det;
        out[at] = static_cast<float>(std::min(kMostStretch, std::sqrt(1 + gx * gx + gy * gy)));
      },
      kCellGrain);
  return out;
}

CalciteRates calcite_rates(Pass& pass, const FilmFlow& flow, const CalciteOptions& o) {
  const Network& n = pass.network();
  const Drainage& drainage = flow.drainage();
  const std::vector<float> stretched = stretch(pass);
  const OptionalReader hardness = pass.reads_optional("hardness", 0);
  CalciteRates out{
      std::vector<double>(n.size(), 0), flow.sources(), std::vector<float>(n.size(), 0), {}};
  out.balance.supplied =
      ordered_sum(out.load.size(), 0.0, [&](size_t i) { return out.load[i].calcium; });
  const auto wetted = [&](uint32_t i) {
    return pass.updates(i) ? static_cast<double>(n.area[i]) * static_cast<double>(stretched[i]) : 0;
  };
  const auto softness = [&](uint32_t i, double excess) {
    return excess < 0 ? std::clamp(1 - static_cast<double>(hardness[i]), 0.0, 1.0) : 1;
  };
  const auto in_cell = [&](uint32_t i, const Load& load) {
    const double excess = load.calcium / load.water - o.equilibrium;
    const double rate =
        o.rate * softness(i, excess) * (1 + gain(flow.speed(i, load.water) / o.agitation));
    const double lost = load.water * excess * share_lost(rate * wetted(i) / load.water);
    out.deposit[i] = lost;
    const Load leaving{load.water, load.calcium - lost};
    out.concentration[i] = static_cast<float>(leaving.calcium / leaving.water);
    return leaving;
  };
  const auto in_pool = [&](uint32_t pool, const Load& load) {
    if (!(load.water > 0)) return load;
    const double arriving = load.calcium / load.water - o.equilibrium;
    double conductance = 0;  // m3/s.
    for (const uint32_t i : drainage.members(pool)) {
      const double through = static_cast<double>(drainage.depth(i)) / kDiffusivity;
      out.deposit[i] = wetted(i) * softness(i, arriving) / (1 / o.rate + through);
      conductance += out.deposit[i];
    }
    const double excess = arriving * load.water / (load.water + conductance);
    double lost = 0;
    for (const uint32_t i : drainage.members(pool)) {
      lost += out.deposit[i] *= excess;
      out.concentration[i] = static_cast<float>(excess + o.equilibrium);
    }
    return Load{load.water, load.calcium - lost};
  };
  out.balance.drained = drainage.route(out.load, in_cell, in_pool).calcium;
  out.balance.deposited =
      ordered_sum(out.deposit.size(), 0.0, [&](size_t i) { return out.deposit[i]; });
  return out;
}

void smooth_deposit(const Pass& pass, double share, int rounds, CalciteRates& rates) {
  const Network& n = pass.network();
  const auto takes_part = [&](uint32_t i) { return rates.load[i].water > 0 && pass.updates(i); };
  std::vector<double> before;
  for (int round = 0; round < rounds; ++round) {
    before = rates.deposit;
    parallel_for(
        before.size(),
        [&](size_t at) {
          const auto i = static_cast<uint32_t>(at);
          if (!takes_part(i)) return;
          const auto area = static_cast<double>(n.area[i]);
          for (const uint32_t j : n.links.of(i)) {
            if (!takes_part(j)) continue;
            const auto other = static_cast<double>(n.area[j]);
            rates.deposit[i] +=
                share / n.full * std::min(area, other) * (before[j] / other - before[i] / area);
          }
        },
        kCellGrain);
  }
}

}  // namespace vug::cells

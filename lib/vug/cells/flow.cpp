// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/cells/flow.h>
#include <vug/cells/integer_power.h>
#include <vug/cells/network.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::cells {
namespace {

constexpr float kGroove = 0.5f;
constexpr float kLevel = 1e-3f;
constexpr float kDrop = 1e-6f;

}  // namespace

int moves_in_step(double speed, double spacing, int step) {
  const double each = std::min(speed / spacing, 1000.0);
  return static_cast<int>(std::floor(each * (step + 1)) - std::floor(each * step));
}

Flow::Flow(const Pass& pass, RandomKey key, const FlowOptions& options)
    : links_(&pass.network().links) {
  const Network& n = pass.network();
  const AttributeReader<Vec3f> position = pass.positions();
  const AttributeReader<CellState> state = pass.states();
  const OptionalReader height = pass.reads_optional("height", 0),
                       water = pass.reads_optional("water", 0);
  const auto rough = static_cast<float>(options.wander * n.spacing);
  level_.resize(n.size());
  parallel_for(
      n.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        const float up = n.normal[i].y, steep = 1 - up * up;
        const auto drawn =
            static_cast<float>(RandomStream(key.at(position_key(n.position[i]))).uniform());
        level_[i] = position[i].y + height[i] * (up + kGroove * steep) + rough * steep * drawn;
      },
      kCellGrain);
  const auto steepness = [&](uint32_t from, uint32_t to) {
    const float drop = level_[from] - level_[to];
    if (!(drop > 0) || !distributes(state[from]) || !receives(state[to])) return 0.0f;
    const float far = (position[to] - position[from]).length();
    // Drops within rounding count as level.
    return drop > kLevel * far ? std::min(1.0f, drop / far) : 0.0f;
  };
  const auto cling = static_cast<float>(options.cling);
  const auto weight = [&](float steep, uint32_t from, uint32_t to) {
    const float straight = integer_power(steep, options.gather);
    if (!(cling > 0)) return straight;
    // 1/2 if both carry the same amount.
    const float wet = water[to] / (water[to] + water[from] + kDrop);
    return straight * (1 - cling + cling * 4 * wet * wet + kDrop);
  };
  total_.resize(n.size());
  steep_.resize(n.size());
  sink_depth_.resize(n.size());
  parallel_for(
      n.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        float total = 0, steepest = 0, lowest = std::numeric_limits<float>::infinity();
        for (const uint32_t to : links_->of(i)) {
          const float steep = steepness(i, to);
          if (steep > 0) total += weight(steep, i, to);
          if (receives(state[to])) lowest = std::min(lowest, level_[to]);
          steepest = std::max(steepest, steep);
        }
        total_[i] = total;
        steep_[i] = steepest;
        sink_depth_[i] = total > 0 || std::isinf(lowest) ? 0 : std::max(0.0f, lowest - level_[i]);
      },
      kCellGrain);
  share_.resize(links_->to.size());
  parallel_for(
      n.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        for (uint32_t k = links_->begin[i]; k < links_->begin[i + 1]; ++k) {
          const uint32_t from = links_->to[k];
          const float steep = steepness(from, i);
          share_[k] = steep > 0 && total_[from] > 0 ? weight(steep, from, i) / total_[from] : 0.0f;
        }
      },
      kCellGrain);
}

}  // namespace vug::cells

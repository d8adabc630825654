// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/evidence/folded_integral.h>
#include <vug/inference/bits.h>

#include <algorithm>

namespace vug::fit {

Gains supervised_gains() {
  Gains out{};
  out[static_cast<size_t>(RegionType::wall)] = kBitStep;
  out[static_cast<size_t>(RegionType::window)] = -kBitStep;
  return out;
}

Gains gains_from_regions(const Sums& windows, const Sums& wall, int lanes) {
  Gains out{};
  double all_windows = 0, all_wall = 0;
  for (size_t i = 0; i < static_cast<size_t>(lanes); ++i) {
    all_windows += windows.lane[i] + 0.5;
    all_wall += wall.lane[i] + 0.5;
  }
  for (size_t i = 0; i < static_cast<size_t>(lanes); ++i)
    out[i] =
        inference::log2((windows.lane[i] + 0.5) / all_windows * all_wall / (wall.lane[i] + 0.5));
  return out;
}

Gains gains_from_grid(const Model& model, const Evidence& evidence, const TreeState& state, int i) {
  if (model.likelihood()->is_supervised()) return supervised_gains();
  Sums windows, wall = sum_of(evidence, state, state.area(i));
  model.each_terminal(state, [&](RegionType type, int node, const Rect& r) {
    if (node <= i || node >= state.tree.end(i)) return;
    const Sums sums = evidence.sums(r.x0, r.y0, r.x1, r.y1);
    if (type == RegionType::window) windows += sums;
    wall -= sums;
  });
  return gains_from_regions(windows, wall, evidence.lanes());
}

double gain_of(const Gains& gains, const Sums& sums) {
  double out = 0;
  for (size_t i = 0; i < gains.size(); ++i) out += gains[i] * sums.lane[i];
  return out;
}

GainMap::GainMap(const Evidence& evidence, const Gains& of)
    : width(evidence.width()), height(evidence.height()) {
  gains.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) gains.push_back(gain_of(of, evidence.sums(x, y, x + 1, y + 1)));
}

FoldedIntegral::FoldedIntegral(const GainMap& map, const TreeState& state, const Area& area)
    : width_(area.width), height_(area.height) {
  const auto w = static_cast<size_t>(width_), h = static_cast<size_t>(height_);
  const auto across = static_cast<size_t>(map.width);
  table_.assign((w + 1) * (h + 1), 0);
  std::vector<double> row(w);
  for (size_t y = 0; y < h; ++y) {
    std::fill(row.begin(), row.end(), 0);
    for (int place = 0; place < area.count; ++place) {
      const AreaInstance& instance = state.instance(area, place);
      const auto begin = map.gains.begin() +
                         static_cast<std::ptrdiff_t>((static_cast<size_t>(area.y) + y) * across) +
                         instance.x;
      for (size_t x = 0; x < w; ++x)
        row[x] += begin[static_cast<std::ptrdiff_t>(instance.mirrored ? w - 1 - x : x)];
    }
    double sum = 0;
    for (size_t x = 0; x < w; ++x) {
      sum += row[x];
      table_[(y + 1) * (w + 1) + x + 1] = table_[y * (w + 1) + x + 1] + sum;
    }
  }
}

FoldedIntegral FoldedIntegral::without(const Rect& rect) const {
  FoldedIntegral out = *this;
  for (int y = rect.y0 + 1; y <= height_; ++y)
    for (int x = rect.x0 + 1; x <= width_; ++x)
      out.table_[static_cast<size_t>(y) * static_cast<size_t>(width_ + 1) +
                 static_cast<size_t>(x)] -=
          sum(rect.x0, rect.y0, std::min(x, rect.x1), std::min(y, rect.y1));
  return out;
}

double FoldedIntegral::potential() const {
  constexpr int kSide = 3;
  double out = 0;
  for (int y = 0; y < height_; y += kSide)
    for (int x = 0; x < width_; x += kSide)
      out += std::max(0.0, sum(x, y, std::min(x + kSide, width_), std::min(y + kSide, height_)));
  return out;
}

}  // namespace vug::fit

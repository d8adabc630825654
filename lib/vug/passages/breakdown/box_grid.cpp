// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/breakdown/box_grid.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

Pile without_blocks(const Pile& pile) {
  Pile out = pile;
  out.blocks.clear();
  out.broken.clear();
  return out;
}

/// The height of the top of a box above a column in plan; -infinity outside of it.
double top_above(const OrientedBox& box, const Vec3d& column) {
  double low = -kInfinity, high = kInfinity;
  const Vec3d offset = column - box.centre;
  for (int i = 0; i < 3; ++i) {
    const double at = box.axes[static_cast<size_t>(i)].dot(offset),
                 rate = box.axes[static_cast<size_t>(i)].y;
    if (std::fabs(rate) < 1e-9) {
      if (std::fabs(at) > box.half[i]) return -kInfinity;
      continue;
    }
    const double one = (-box.half[i] - at) / rate, two = (box.half[i] - at) / rate;
    low = std::max(low, std::min(one, two));
    high = std::min(high, std::max(one, two));
  }
  return low <= high ? column.y + high : -kInfinity;
}

}  // namespace

std::pair<int, int> BoxGrid::cell_of(const Vec3d& p) const {
  return {static_cast<int>(std::floor(p.x / cell_)), static_cast<int>(std::floor(p.z / cell_))};
}

TopMap::TopMap(const Pile& pile, double margin) : cone_(without_blocks(pile)) {
  constexpr int kColumns = 240;
  const double reach = pile.ridge + pile.height / pile.slope + margin;
  count_ = kColumns;
  cell_ = 2 * reach / kColumns;
  start_x_ = pile.foot.x - reach;
  start_z_ = pile.foot.z - reach;
  tops_.assign(static_cast<size_t>(count_ * count_), 0);
}

Vec3d TopMap::column(int i, int j) const {
  return {start_x_ + (i + 0.5) * cell_, cone_.foot.y, start_z_ + (j + 0.5) * cell_};
}

std::pair<int, int> TopMap::index(double x, double z) const {
  const auto clamped = [&](double t) {
    return static_cast<int>(std::clamp(std::floor(t / cell_), 0.0, count_ - 1.0));
  };
  return {clamped(x - start_x_), clamped(z - start_z_)};
}

void TopMap::add(const OrientedBox& block) {
  const Box3d box = block.bounds();
  const auto [i0, j0] = index(box.min.x, box.min.z);
  const auto [i1, j1] = index(box.max.x, box.max.z);
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) {
      const double height = top_above(block, column(i, j)) - cone_.foot.y;
      if (height <= top(i, j)) continue;
      sum_ += height - top(i, j);
      top(i, j) = height;
    }
}

double TopMap::mean_lack(const Vec3d& p, double half) const {
  const auto [i0, j0] = index(p.x - half, p.z - half);
  const auto [i1, j1] = index(p.x + half, p.z + half);
  double lack = 0;
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i)
      lack += std::max(0.0, cone_.cone(column(i, j))) - tops_[static_cast<size_t>(j * count_ + i)];
  return lack / ((i1 - i0 + 1) * (j1 - j0 + 1));
}

}  // namespace vug::passages

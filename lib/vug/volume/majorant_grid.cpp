// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/majorant_grid.h>

namespace vug::volume {

MajorantGrid::MajorantGrid(int size, const Vec3i& reach) : size_(size), reach_(reach) {
  for (int axis = 0; axis < 3; ++axis) count_[axis] = (reach[axis] + size - 1) / size;
  row_ = static_cast<size_t>(count_.x) + 2;
  plane_ = row_ * (static_cast<size_t>(count_.y) + 2);
  ranges_.resize(plane_ * (static_cast<size_t>(count_.z) + 2));
}

MajorantGrid MajorantGrid::doubled() const {
  MajorantGrid out(2 * size_, reach_);
  out.each([&](const Vec3i& brick) {
    const Vec3i first = brick * 2;
    Range all = range(index(first));
    double sum = 0, voxels_in = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3i at = first + Vec3i(corner & 1, corner >> 1 & 1, corner >> 2);
      if (at.x >= count_.x || at.y >= count_.y || at.z >= count_.z) continue;
      const Range& part = range(index(at));
      all.min = std::min(all.min, part.min);
      all.max = std::max(all.max, part.max);
      sum += voxels(at) * static_cast<double>(part.mean);
      voxels_in += voxels(at);
    }
    all.mean = std::clamp(static_cast<float>(sum / voxels_in), all.min, all.max);
    out.set(brick, all);
  });
  return out;
}

double MajorantGrid::voxels(const Vec3i& brick) const {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis)
    product *= std::min(size_, reach_[axis] - brick[axis] * size_);
  return product;
}

double MajorantGrid::bound() const {
  double sum = 0;
  each([&](const Vec3i& brick) {
    sum += voxels(brick) * static_cast<double>(range(index(brick)).max);
  });
  return sum;
}

}  // namespace vug::volume

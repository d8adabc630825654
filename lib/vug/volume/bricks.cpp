#include <vug/volume/bricks.h>

namespace vug::volume {

Bricks::Bricks(int size, const Vec3i& reach) : size_(size), reach_(reach) {
  for (int axis = 0; axis < 3; ++axis) count_[axis] = (reach[axis] + size - 1) / size;
  row_ = static_cast<size_t>(count_.x) + 2;
  plane_ = row_ * (static_cast<size_t>(count_.y) + 2);
  ranges_.resize(plane_ * (static_cast<size_t>(count_.z) + 2));
}

Bricks Bricks::doubled() const {
  Bricks out(2 * size_, reach_);
  out.each([&](const Vec3i& brick) {
    const Vec3i first = brick * 2;
    Range all = range(index(first));
    double sum = 0, voxels_in = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3i at = first + Vec3i(corner & 1, corner >> 1 & 1, corner >> 2);
      if (at.x >= count_.x || at.y >= count_.y || at.z >= count_.z) continue;
      const Range& part = range(index(at));
      all.least = std::min(all.least, part.least);
      all.most = std::max(all.most, part.most);
      sum += voxels(at) * static_cast<double>(part.mean);
      voxels_in += voxels(at);
    }
    all.mean = std::clamp(static_cast<float>(sum / voxels_in), all.least, all.most);
    out.set(brick, all);
  });
  return out;
}

double Bricks::voxels(const Vec3i& brick) const {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis)
    product *= std::min(size_, reach_[axis] - brick[axis] * size_);
  return product;
}

double Bricks::bound() const {
  double sum = 0;
  each([&](const Vec3i& brick) {
    sum += voxels(brick) * static_cast<double>(range(index(brick)).most);
  });
  return sum;
}

}  // namespace vug::volume

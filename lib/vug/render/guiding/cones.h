// A density over directions: a few cones, each even within.
#pragma once

#include <vug/render/vectors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace vug::render {

/// At most kMost cones with their shares, made anew for each place that asks for directions.
class Cones {  // NOLINT: only what has been added is read
 public:
  static constexpr size_t kMost = 32;

  size_t size() const { return size_; }
  /// At most kMost; axis: unit; opening: 1 - cosine at the rim; opening, share > 0. `name` is the
  /// caller's.
  void add(const Vec3f& axis, float opening, float share, uint32_t name) {
    x_[size_] = axis.x, y_[size_] = axis.y, z_[size_] = axis.z;
    open_[size_] = opening, density_[size_] = share, names_[size_] = name;
    until_[size_] = share + (size_ > 0 ? until_[size_ - 1] : 0);
    ++size_;
  }
  /// Makes the shares parts of one, and sets how much of all sampling is theirs.
  void settle(float trust);
  /// 0 to 1; 0 without cones.
  float trust() const { return trust_; }

  /// A cone by its share; these three only with cones.
  size_t choose(float u) const {
    size_t i = 0;
    while (i + 1 < size_ && u >= until_[i]) ++i;
    return i;
  }
  uint32_t name(size_t cone) const { return names_[cone]; }
  Vec3f sample(const Vec2f& u) const;
  /// Over solid angle.
  float pdf(const Vec3f& direction) const {
    float sum = 0;
    for (size_t i = 0; i < size_; ++i) {
      const float cosine = x_[i] * direction.x + y_[i] * direction.y + z_[i] * direction.z;
      sum += 1 - cosine <= open_[i] ? density_[i] : 0;
    }
    return sum;
  }

 private:
  // The axis; the opening; the density; the sum of shares up to this cone.
  std::array<float, kMost> x_, y_, z_, open_, density_, until_;
  std::array<uint32_t, kMost> names_;
  size_t size_ = 0;
  float trust_ = 0;
};

}  // namespace vug::render

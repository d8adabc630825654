// SPDX-License-Identifier: Apache-2.0
// Traversal of the bricks of a density grid along a ray (Amanatides and Woo 1987, "A fast voxel
// traversal algorithm for ray tracing", cite amanatides1987traversal).
#pragma once

#include <vug/render/media/medium.h>
#include <vug/volume/density.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::render {

class BrickTraversal {
 public:
  /// Clips the segment to the density's box and traverses its bricks of one size.
  BrickTraversal(const volume::Density& density, const volume::MajorantGrid& bricks, const Ray& ray,
                 const Segment& segment)
      : bricks_(bricks),
        origin_(density.to_index(ray.origin)),
        direction_(density.direction_to_index(ray.direction)),
        t_(segment.begin),
        end_(segment.end) {
    Vec3f per(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const float o = origin_[axis], d = direction_[axis], size = density.size()[axis];
      if (d == 0) {
        if (!(o >= 0 && o < size)) end_ = t_;
        continue;
      }
      per[axis] = 1 / d;
      const float low = -o * per[axis], high = (size - o) * per[axis];
      t_ = std::max(t_, std::min(low, high));
      end_ = std::min(end_, std::max(low, high));
    }
    if (!(t_ < end_)) return;
    const auto side = static_cast<float>(bricks.size());
    const Vec3f at = index(t_);
    Vec3i brick;
    const ptrdiff_t strides[] = {1, static_cast<ptrdiff_t>(bricks.row()),
                                 static_cast<ptrdiff_t>(bricks.plane())};
    for (int axis = 0; axis < 3; ++axis) {
      const int last = bricks.count()[axis] - 1;
      brick[axis] = std::clamp(static_cast<int>(at[axis] / side), 0, last);
      const float d = direction_[axis];
      step_[static_cast<size_t>(axis)] = d > 0 ? strides[axis] : -strides[axis];
      next_[axis] =
          d != 0 ? (side * static_cast<float>(brick[axis] + (d > 0)) - origin_[axis]) * per[axis]
                 : kFar;
      apart_[axis] = d != 0 ? side * std::fabs(per[axis]) : kFar;
    }
    at_ = bricks.index(brick);
  }
  Vec3f index(float t) const { return origin_ + direction_ * t; }

  /// The part of the ray inside one brick.
  struct Interval {
    float begin = 0, end = 0;
    volume::MajorantGrid::Range range;
  };
  /// Advances to the next brick that is not empty; false at the end. A position that rounding puts
  /// outside the bricks is in their empty rim, where the traversal ends.
  bool next(Interval& step) {
    while (t_ < end_) {
      step = {t_, std::min(std::min(next_.x, next_.y), std::min(next_.z, end_)),
              bricks_.range(at_)};
      // The branch would be unpredictable, so the code is branch-free.
      const bool x = next_.x <= next_.y && next_.x <= next_.z, y = !x && next_.y <= next_.z;
      const bool z = !x && !y;
      at_ += static_cast<size_t>(x ? step_[0] : y ? step_[1] : step_[2]);
      next_.x += x ? apart_.x : 0;
      next_.y += y ? apart_.y : 0;
      next_.z += z ? apart_.z : 0;
      t_ = std::max(t_, step.end);
      if (step.range.max > 0 && step.end > step.begin) return true;
    }
    return false;
  }

 private:
  const volume::MajorantGrid& bricks_;
  Vec3f origin_, direction_, next_{0, 0, 0}, apart_{0, 0, 0};
  std::array<ptrdiff_t, 3> step_{0, 0, 0};
  size_t at_ = 0;
  float t_, end_;
};

}  // namespace vug::render

// A ray's way through the bricks of a density (Amanatides and Woo 1987, "A fast voxel traversal
// algorithm for ray tracing", cite amanatides1987traversal).
#pragma once

#include <vug/render/medium.h>
#include <vug/volume/density.h>

#include <algorithm>

namespace vug::render {

/// The segment must lie in the density's bounds.
class BrickWalk {
 public:
  BrickWalk(const volume::Density& density, const Ray& ray, const Segment& segment)
      : density_(density),
        origin_(density.to_index(ray.origin)),
        direction_(density.direction_to_index(ray.direction)),
        t_(segment.begin),
        end_(segment.end) {
    const Vec3f at = index(t_);
    for (int axis = 0; axis < 3; ++axis) {
      const int last = density.bricks()[axis] - 1;
      brick_[axis] =
          std::clamp(static_cast<int>(std::floor(at[axis] / volume::Density::kSize)), 0, last);
      const float d = direction_[axis];
      step_[axis] = d > 0 ? 1 : -1;
      const auto edge = static_cast<float>((brick_[axis] + (d > 0)) * volume::Density::kSize);
      next_[axis] = d != 0 ? (edge - origin_[axis]) / d : kFar;
      apart_[axis] = d != 0 ? volume::Density::kSize / std::fabs(d) : kFar;
    }
  }
  Vec3f index(float t) const { return origin_ + direction_ * t; }

  /// Calls visit(begin, end, range of values) for the parts of the ray in bricks until it returns
  /// false.
  template <class Visit>
  void each(const Visit& visit) {
    while (t_ < end_) {
      int axis = next_.x < next_.y ? 0 : 1;
      if (next_.z < next_[axis]) axis = 2;
      const float leave = std::min(next_[axis], end_);
      if (leave > t_) {
        const volume::Density::Range range = density_.range(brick_);
        if (range.most > 0 && !visit(t_, leave, range)) return;
        t_ = leave;
      }
      brick_[axis] += step_[axis];
      next_[axis] += apart_[axis];
      if (brick_[axis] < 0 || brick_[axis] >= density_.bricks()[axis]) return;
    }
  }

 private:
  const volume::Density& density_;
  Vec3f origin_, direction_, next_{0, 0, 0}, apart_{0, 0, 0};
  Vec3i brick_{0, 0, 0}, step_{0, 0, 0};
  float t_, end_;
};

}  // namespace vug::render

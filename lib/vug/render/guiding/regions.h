// SPDX-License-Identifier: Apache-2.0
// Cubic regions of a scene's bounding box; points in the same region share their training data.
#pragma once

#include <vug/render/vectors.h>

#include <algorithm>
#include <array>

namespace vug::render {

/// In metres; never 0.
inline float diagonal_of(const Box3f& box) { return std::max(length(box.size()), 1e-3f); }

class Regions {
 public:
  /// A single region for all points.
  Regions() = default;
  /// `edge` of the cubes is a fraction of the box's diagonal. Points outside the box belong to the
  /// nearest cube.
  Regions(const Box3f& box, float edge)
      : origin_(box.min), per_metre_(1 / (edge * diagonal_of(box))) {
    for (int axis = 0; axis < 3; ++axis)
      counts_[static_cast<size_t>(axis)] =
          std::max(1, static_cast<int>(std::ceil(box.size()[axis] * per_metre_)));
  }

  /// Calls `each` with every member, for files.
  template <class Self, class Each>
  static void visit(Self& self, const Each& each) {
    each(self.origin_), each(self.per_metre_), each(self.counts_);
  }

  size_t count() const {
    return static_cast<size_t>(counts_[0]) * static_cast<size_t>(counts_[1]) *
           static_cast<size_t>(counts_[2]);
  }
  /// Index below `count`.
  size_t at(const Vec3f& point) const {
    size_t index = 0;
    for (int axis = 2; axis >= 0; --axis) {
      const int count = counts_[static_cast<size_t>(axis)];
      const float along = std::floor((point[axis] - origin_[axis]) * per_metre_);
      const float kept = std::clamp(along, 0.0f, static_cast<float>(count - 1));
      index = index * static_cast<size_t>(count) + static_cast<size_t>(kept);
    }
    return index;
  }

 private:
  Vec3f origin_{0, 0, 0};
  float per_metre_ = 1;
  std::array<int, 3> counts_{1, 1, 1};
};

}  // namespace vug::render

// SPDX-License-Identifier: Apache-2.0
#include <vug/render/media/medium.h>

#include <algorithm>

namespace vug::render {

Segment clip_to_box(const Box3f& box, const Ray& ray, float end) {
  float begin = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float d = ray.direction[axis], o = ray.origin[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) return {0, 0};
      continue;
    }
    const float a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return {begin, end};
}

}  // namespace vug::render

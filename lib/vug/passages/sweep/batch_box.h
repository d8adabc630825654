// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the extent of a batch of points.
#pragma once

#include <vug/field/node.h>

#include <algorithm>

namespace vug::passages {

using field::Pack, field::Point;

inline float lowest(Pack x) {
  __m128 least = _mm_min_ps(_mm256_castps256_ps128(x.v), _mm256_extractf128_ps(x.v, 1));
  least = _mm_min_ps(least, _mm_movehl_ps(least, least));
  return _mm_cvtss_f32(_mm_min_ss(least, _mm_movehdup_ps(least)));
}
inline float highest(Pack x) { return -lowest(-x); }

/// A box around all points of a batch, by its centre and half its size.
struct BatchBox {
  Vec3d centre, half;
  field::Ball ball() const { return {centre, half.length()}; }
};

inline BatchBox box_around(const Point<Pack>* points, size_t count) {
  Pack low[3] = {points[0].x, points[0].y, points[0].z}, high[3] = {low[0], low[1], low[2]};
  for (size_t i = 1; i < count; ++i) {
    const Pack at[3] = {points[i].x, points[i].y, points[i].z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = min(low[axis], at[axis]);
      high[axis] = max(high[axis], at[axis]);
    }
  }
  Vec3d least, most;
  for (int axis = 0; axis < 3; ++axis) {
    least[axis] = static_cast<double>(lowest(low[axis]));
    most[axis] = static_cast<double>(highest(high[axis]));
  }
  return {0.5 * (least + most), 0.5 * (most - least)};
}

}  // namespace vug::passages

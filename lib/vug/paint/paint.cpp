// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/paint/paint.h>

#include <algorithm>

namespace vug::paint {

double ramp(double x, double from, double to) {
  if (from == to) return x < from ? 0 : 1;
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

AttributeUses attribute_uses(const Mask& mask, const Paint& a, const Paint& b) {
  AttributeUses all = mask ? mask->uses() : AttributeUses{};
  for (const Paint& paint : {a, b})
    if (paint) all.add(paint->uses());
  return all;
}

std::vector<Vec3f> colors(const Paint& paint, const std::vector<EvalPoint>& points) {
  std::vector<Vec3f> out(points.size());
  parallel_for(
      points.size(),
      [&](size_t i) {
        const Vec3d color = (*paint)(points[i]);
        for (int c = 0; c < 3; ++c) out[i][c] = static_cast<float>(std::clamp(color[c], 0.0, 1.0));
      },
      1024);
  return out;
}

}  // namespace vug::paint

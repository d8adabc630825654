#include <vug/base/parallel.h>
#include <vug/paint/paint.h>

#include <algorithm>

namespace vug::paint {

double ramp(double x, double from, double to) {
  if (from == to) return x < from ? 0 : 1;
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Uses uses_of(const Mask& mask, const Paint& a, const Paint& b) {
  Uses all = mask ? mask->uses() : Uses{};
  for (const Paint& paint : {a, b})
    if (paint) all.insert(all.end(), paint->uses().begin(), paint->uses().end());
  return all;
}

std::vector<Vec3f> colors(const Paint& paint, const std::vector<Spot>& spots) {
  std::vector<Vec3f> out(spots.size());
  parallel_for(
      spots.size(),
      [&](size_t i) {
        const Vec3d color = (*paint)(spots[i]);
        for (int c = 0; c < 3; ++c) out[i][c] = static_cast<float>(std::clamp(color[c], 0.0, 1.0));
      },
      1024);
  return out;
}

}  // namespace vug::paint

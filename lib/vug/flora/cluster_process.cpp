// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/cluster_process.h>

namespace vug::flora {

std::vector<Vec2d> cluster_points(const Plot& plot, double density, RandomKey key,
                                  Progress& progress, const ClusterProcessOptions& options) {
  const Vec2d low = plot.low() - Vec2d(options.reach), high = plot.high() + Vec2d(options.reach);
  const double area = (high.x - low.x) * (high.y - low.y);
  require_density(density, area);
  require_density(density / options.per_clump, area);
  RandomStream number(key.at("number"));
  const uint64_t clumps = poisson(area * density / options.per_clump, number);
  std::vector<Vec2d> points;
  for (uint64_t i = 0; i < clumps; ++i) {
    if (i % 4096 == 0) progress.check();
    const RandomKey own = key.at(i);
    RandomStream random(own);
    const Vec2d middle(random.uniform(low.x, high.x), random.uniform(low.y, high.y));
    const uint64_t stems = poisson(options.per_clump, random);
    for (uint64_t stem = 0; stem < stems; ++stem) {
      RandomStream stem_random(own.at(stem));
      const Vec2d p = middle + options.offset(stem_random);
      if (plot.contains(p)) points.push_back(p);
    }
  }
  return points;
}

}  // namespace vug::flora

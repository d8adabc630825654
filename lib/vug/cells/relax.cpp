// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/relax.h>
#include <vug/cells/surface_distance.h>
#include <vug/mesh/point_grid.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

struct ForceLaw {
  Force force;
  float reach, spacing;

  float operator()(float d) const {
    const float rest = 1 - d / reach;
    return force == Force::squared ? rest * rest : (1 - d / spacing) * rest;
  }
};

/// The effect of the surrounding cells on one cell.
struct Push {
  Vec3f displacement{0, 0, 0};  ///< In spacings times the maximum push.
  float nearest2;  ///< Squared distance to the nearest cell; that of the reach without cells in it.
};

Push push_on(uint32_t i, const std::vector<SurfacePoint>& places,
             const mesh::PointGrid::Runs& around, const ForceLaw& law) {
  const SurfacePoint& own = places[i];
  const float reach2 = law.reach * law.reach;
  Push push;
  push.nearest2 = reach2;
  for (const mesh::PointGrid::Run& run : around)
    for (uint32_t j = run.begin; j < run.end; ++j) {
      const Vec3f d = own.position - places[j].position;
      if (j == i || d.length2() >= reach2) continue;
      const float d2 =
          surface_distance2(own.position, own.normal, places[j].position, places[j].normal);
      if (!(d2 < reach2)) continue;
      push.nearest2 = std::min(push.nearest2, d2);
      const Vec3f flat = d - own.normal * own.normal.dot(d);
      const float length = flat.length();
      if (length > 0) push.displacement += flat * (law(std::sqrt(d2)) / length);
    }
  return push;
}

}  // namespace

std::vector<RelaxStep> relax(std::vector<SurfacePoint>& places, const Surface& surface,
                             double spacing, double reach, const RelaxOptions& options,
                             Progress& progress) {
  progress.begin("relaxing cells", static_cast<uint64_t>(std::max(0, options.steps)));
  const SurfaceSearch search(surface);
  const ForceLaw law{options.force, static_cast<float>(reach), static_cast<float>(spacing)};
  const auto strength = static_cast<float>(options.strength * spacing);
  const auto most = static_cast<float>(0.3 * spacing);
  std::vector<RelaxStep> steps;
  std::vector<SurfacePoint> sorted(places.size());
  std::vector<float> nearest(places.size()), moved(places.size());
  for (int step = 0; step < options.steps && !places.empty(); ++step) {
    progress.check();
    const mesh::PointGrid grid(positions(places), reach);
    for (size_t i = 0; i < places.size(); ++i) sorted[i] = places[grid.order()[i]];
    grid.for_each_cube([&](mesh::PointGrid::Run cube, const mesh::PointGrid::Runs& around) {
      for (uint32_t i = cube.begin; i < cube.end; ++i) {
        const Push push = push_on(i, sorted, around, law);
        Vec3f displacement = push.displacement * strength;
        const float length = displacement.length();
        if (length > most) displacement *= most / length;
        nearest[i] = std::sqrt(push.nearest2);
        moved[i] = std::min(length, most);
        places[i] = moved[i] > 0
                        ? search.nearest(sorted[i].position + displacement, sorted[i], moved[i])
                        : sorted[i];
      }
    });
    const auto count = static_cast<double>(places.size());
    const auto mean = [&](const auto& term) {
      return ordered_sum(places.size(), 0.0, term) / count;
    };
    RelaxStep statistics;
    statistics.nearest = mean([&](size_t i) { return static_cast<double>(nearest[i]); });
    statistics.displacement = mean([&](size_t i) { return static_cast<double>(moved[i]); });
    const double squares = mean([&](size_t i) {
      const double off = static_cast<double>(nearest[i]) - statistics.nearest;
      return off * off;
    });
    statistics.variation = statistics.nearest > 0 ? std::sqrt(squares) / statistics.nearest : 0;
    steps.push_back(statistics);
    progress.advance();
  }
  progress.end();
  return steps;
}

}  // namespace vug::cells

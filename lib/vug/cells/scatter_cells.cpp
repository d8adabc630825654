// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/lattice.h>
#include <vug/cells/network.h>
#include <vug/cells/scatter_cells.h>
#include <vug/cells/surface_distance.h>
#include <vug/mesh/sample_elimination.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

constexpr size_t kChunk = 256;
/// Rounds of dart throwing, each with one dart per squared gap: further rounds find little room. A
/// pattern leaves gaps only along its seams.
constexpr uint64_t kRounds = 6, kSeamRounds = 3;

/// Collects the results of add(triangle, list) for all triangles, in order.
template <class Add>
std::vector<SurfacePoint> collect(size_t triangles, const Add& add) {
  std::vector<std::vector<SurfacePoint>> parts((triangles + kChunk - 1) / kChunk);
  parallel_for(parts.size(), [&](size_t part) {
    const size_t end = std::min(triangles, (part + 1) * kChunk);
    for (size_t i = part * kChunk; i < end; ++i) add(static_cast<uint32_t>(i), parts[part]);
  });
  std::vector<SurfacePoint> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

RandomKey key_of(const Surface::Triangle& t, RandomKey key) {
  for (const Vec3f& corner : t.corners) key = key.at(position_key(corner));
  return key;
}

/// Throws darts at one triangle, with a mean of `density` per square metre.
void throw_darts(const Surface& surface, uint32_t triangle, double density, RandomKey key,
                 std::vector<SurfacePoint>& out) {
  RandomStream random(key_of(surface.triangles()[triangle], key));
  const double count = std::floor(surface.area(triangle) * density + random.uniform());
  for (double i = 0; i < count; ++i) {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    out.push_back(surface.at(triangle, u, v));
  }
}

/// Keeps the first `kept` points, and of the others those that fit. Sorts all into an order that
/// follows space.
void thin(std::vector<SurfacePoint>& places, size_t kept, double radius, RandomKey key) {
  const mesh::PointGrid grid(positions(places), radius);
  std::vector<SurfacePoint> sorted(places.size());
  std::vector<uint64_t> rank(places.size());
  parallel_for(
      places.size(),
      [&](size_t i) {
        sorted[i] = places[grid.order()[i]];
        rank[i] = grid.order()[i] < kept ? 0 : (position_key(sorted[i].position) ^ key.state()) | 1;
      },
      kCellGrain);
  const auto limit = static_cast<float>(radius * radius);
  const auto stays = mesh::eliminate_samples(grid, rank, [&](uint32_t i, uint32_t j) {
    const Vec3f &p = grid.points()[i], &q = grid.points()[j];
    return (p - q).length2() < limit &&
           surface_distance2(p, sorted[i].normal, q, sorted[j].normal) < limit;
  });
  size_t count = 0;
  for (size_t i = 0; i < sorted.size(); ++i)
    if (stays[i]) places[count++] = sorted[i];
  places.resize(count);
}

}  // namespace

std::vector<SurfacePoint> scatter_cells(const Surface& surface, const Grid& grid, double spacing,
                                        RandomKey key, Progress& progress) {
  const size_t triangles = surface.triangles().size();
  const uint64_t rounds = grid.motif.empty() ? kRounds : kSeamRounds;
  progress.begin("scattering cells", rounds);
  std::vector<SurfacePoint> places;
  if (!grid.motif.empty()) {
    const std::vector<Vec3d> planes = pattern_planes(surface, spacing);
    places = collect(triangles, [&](uint32_t i, std::vector<SurfacePoint>& out) {
      add_lattice(surface, i, {grid, spacing, planes[i], key.at("lattice")}, out);
    });
    thin(places, 0, grid.thin * spacing, key.at("thin"));
  }
  const double gap = grid.gap * spacing;
  for (uint64_t round = 0; round < rounds; ++round) {
    progress.advance();
    progress.check();
    const RandomKey own = key.at("darts").at(round);
    const std::vector<SurfacePoint> darts =
        collect(triangles, [&](uint32_t i, std::vector<SurfacePoint>& out) {
          throw_darts(surface, i, 1 / (gap * gap), own, out);
        });
    const size_t kept = places.size();
    places.insert(places.end(), darts.begin(), darts.end());
    thin(places, kept, gap, own);
  }
  progress.end();
  return places;
}

}  // namespace vug::cells

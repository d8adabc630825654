// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/lattice.h>
#include <vug/cells/network.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace vug::cells {
namespace {

constexpr double kFine = 512, kCoarse = 4;
constexpr double kFacet = 16;

Vec3i bin(const Vec3d& normal, double bins) {
  const auto part = [&](double x) { return static_cast<int>(std::lround(x * bins)); };
  return {part(normal.x), part(normal.y), part(normal.z)};
}

/// Plane coordinates in periods of the pattern.
struct Frame {
  Vec3d right, ahead;
  Vec2d across, along, phase;  ///< Rows of the inverse period matrix, and an offset.

  Frame(const Vec3d& n, const Grid& grid, double spacing, RandomKey key) {
    const Vec3d level = std::fabs(n.y) < 0.9 ? Vec3d(0, 1, 0).cross(n) : Vec3d(1, 0, 0);
    right = (level - n * level.dot(n)).normalized();
    ahead = n.cross(right);
    const double area = grid.across.x * grid.along.y - grid.across.y * grid.along.x;
    across = Vec2d(grid.along.y, -grid.along.x) / (area * spacing);
    along = Vec2d(-grid.across.y, grid.across.x) / (area * spacing);
    RandomStream random(key.at(position_key(Vec3f(n))));
    const double x = random.uniform();
    phase = Vec2d(x, random.uniform());
  }

  Vec2d operator()(const Vec3f& p) const {
    const Vec2d flat(Vec3d(p).dot(right), Vec3d(p).dot(ahead));
    return Vec2d(across.dot(flat), along.dot(flat)) + phase;
  }
};

/// The intersection of the side from a to b with a row; identical for both directions of the side.
double crossing(const Vec2d& a, const Vec2d& b, double row) {
  if (b.y < a.y || (b.y == a.y && b.x < a.x)) return crossing(b, a, row);
  return a.x + (b.x - a.x) * ((row - a.y) / (b.y - a.y));
}

}  // namespace

std::vector<Vec3d> pattern_planes(const Surface& surface, double spacing) {
  const size_t count = surface.triangles().size();
  std::vector<uint64_t> facet(count);
  std::unordered_map<uint64_t, double> area;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3i b = bin(surface.face_normal(i), kFine) + Vec3i(512);
    facet[i] = static_cast<uint64_t>(b.x) << 40 | static_cast<uint64_t>(b.y) << 20 |
               static_cast<uint64_t>(b.z);
    area[facet[i]] += surface.area(i);
  }
  std::vector<Vec3d> normals(count);
  for (uint32_t i = 0; i < count; ++i) {
    const bool flat = area[facet[i]] >= kFacet * spacing * spacing;
    normals[i] = Vec3d(bin(surface.face_normal(i), flat ? kFine : kCoarse)).normalized();
  }
  return normals;
}

void add_lattice(const Surface& surface, uint32_t triangle, const Lattice& lattice,
                 std::vector<SurfacePoint>& out) {
  const Grid& grid = lattice.grid;
  const Frame frame(lattice.normal, grid, lattice.spacing, lattice.key);
  const Surface::Triangle& t = surface.triangles()[triangle];
  const double area = grid.across.x * grid.along.y - grid.across.y * grid.along.x;
  for (const Vec2d& m : grid.motif) {
    const Vec2d shift((m.x * grid.along.y - m.y * grid.along.x) / area,
                      (m.y * grid.across.x - m.x * grid.across.y) / area);
    std::array<Vec2d, 3> c;
    for (size_t k = 0; k < 3; ++k) c[k] = frame(t.corners[k]) - shift;
    const Vec2d ab = c[1] - c[0], ac = c[2] - c[0];
    const double twice = ab.x * ac.y - ab.y * ac.x;
    if (twice == 0) continue;
    const double low = std::ceil(std::min({c[0].y, c[1].y, c[2].y}));
    const double high = std::max({c[0].y, c[1].y, c[2].y});
    for (double row = low; row < high; ++row) {
      double x[2];
      size_t sides = 0;
      for (size_t k = 0; k < 3 && sides < 2; ++k) {
        const Vec2d &a = c[k], &b = c[(k + 1) % 3];
        if ((a.y <= row) != (b.y <= row)) x[sides++] = crossing(a, b, row);
      }
      if (sides < 2) continue;
      const double end = std::max(x[0], x[1]);
      for (double column = std::ceil(std::min(x[0], x[1])); column < end; ++column) {
        const Vec2d p = Vec2d(column, row) - c[0];
        const double u = (p.x * ac.y - p.y * ac.x) / twice;
        out.push_back(surface.at(triangle, u, (ab.x * p.y - ab.y * p.x) / twice));
      }
    }
  }
}

}  // namespace vug::cells

// SPDX-License-Identifier: Apache-2.0
// Estimates of the voxels, the memory and the area of a level set, made before it is built.
//
// On average, a surface of area A meets A * w / size^3 cubes of edge `size`, where w is the width
// of the slab that must contain the cube's centre: the band plus the cube's mean extent along the
// normal, 3/2 of its edge (Cauchy's mean projection of a cube).
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/volume/region.h>
#include <vug/volume/voxelize.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::volume {
namespace {

struct Sample {
  field::Field field;
  Vec3d centre;
};

/// Cells of edge `size` that may be within `size` of the surface, each of which represents
/// `weight` of them.
struct Shell {
  std::vector<Sample> cells;
  double size = 0;
  double weight = 1;
};

// Refinement ends when it no longer changes the area, that is when the features of a crowded scene
// are resolved. From kEnough cells on, the area is estimated; of more than kMost cells, a sample
// is refined, because each cell holds the part of the expression that matters in it.
constexpr size_t kEnough = 1024, kMost = 3 * kEnough;
constexpr double kSettled = 0.05;

/// Every n-th cell. Cells follow each other in the order of an octree, so each of these represents
/// its neighbours; n is odd, so that all eight children of cells take their turn.
void thin(Shell& shell) {
  if (shell.cells.size() <= kMost) return;
  const size_t every = (shell.cells.size() + kMost - 1) / kMost | 1;
  std::vector<Sample> kept;
  for (size_t i = 0; i < shell.cells.size(); i += every) kept.push_back(std::move(shell.cells[i]));
  shell.weight *= static_cast<double>(shell.cells.size()) / static_cast<double>(kept.size());
  shell.cells = std::move(kept);
}

Shell refine(const Shell& outer) {
  Shell inner;
  inner.size = outer.size / 2;
  inner.weight = outer.weight;
  std::vector<std::vector<Sample>> kept(outer.cells.size());
  parallel_for(outer.cells.size(), [&](size_t i) {
    const Sample& cell = outer.cells[i];
    for (int n = 0; n < 8; ++n) {
      const double step = 0.5 * inner.size;
      const Vec3d centre =
          cell.centre + Vec3d(n & 4 ? step : -step, n & 2 ? step : -step, n & 1 ? step : -step);
      const double reach = inner.size * cell.field.lipschitz();
      field::Field::RestrictedField part =
          cell.field.restricted_near({centre, step * std::sqrt(3.0)}, reach);
      if (part.range.lo <= reach && part.range.hi >= -reach)
        kept[i].push_back({std::move(part.field), centre});
    }
  });
  for (auto& list : kept)
    for (Sample& s : list) inner.cells.push_back(std::move(s));
  thin(inner);
  return inner;
}

/// Each point of a lattice with spacing a = size/2 that is nearer than a to the surface represents
/// a^3 / (2a) of its area.
double area(const Shell& shell) {
  const double a = 0.5 * shell.size;
  const double near = ordered_sum(shell.cells.size(), 0.0, [&](size_t i) {
    const Sample& cell = shell.cells[i];
    double count = 0;
    for (int n = 0; n < 8; ++n) {
      const double step = 0.5 * a;
      const field::Gradient g = cell.field.gradient(
          cell.centre + Vec3d(n & 4 ? step : -step, n & 2 ? step : -step, n & 1 ? step : -step));
      if (std::fabs(g.value) < a * g.gradient.length()) ++count;
    }
    return count;
  });
  return shell.weight * near * a * a / 2;
}

double cubes(double area, double edge, double band) {
  return area * (2 * band + 1.5 * edge) / (edge * edge * edge);
}

}  // namespace

VoxelizeEstimate estimate(const field::Field& whole, const VoxelizeOptions& options) {
  const Region region = region_of(whole, options);
  VoxelizeEstimate out;
  if (region.box.isEmpty()) return out;
  const double band = options.half_width * options.voxel;
  const Box3d box = grown(region.box, band);
  const Vec3d extent = box.size();
  Shell shell;
  shell.size = std::max({extent.x, extent.y, extent.z});
  shell.cells = {{region.field, box.center()}};
  while (!shell.cells.empty() && shell.size > 4 * options.voxel) {
    shell = refine(shell);
    if (shell.cells.size() < kEnough) continue;
    const double before = out.surface_area;
    out.surface_area = area(shell);
    if (std::fabs(out.surface_area - before) < kSettled * out.surface_area) break;
  }
  if (shell.cells.size() < kEnough) out.surface_area = area(shell);
  const double voxel = options.voxel;
  out.active_voxels = out.surface_area * 2 * options.half_width / (voxel * voxel);
  const double edge = 8 * voxel;
  const double all = (extent.x / edge + 2) * (extent.y / edge + 2) * (extent.z / edge + 2);
  out.leaves = std::min(all, cubes(out.surface_area, edge, band));
  out.active_voxels = std::min(out.active_voxels, 512 * out.leaves);
  // sizeof the nodes of a float tree, plus the overhead of the allocator.
  const double leaf = 2048 + 64 + 64 + 48, lower = 4096 * 8 + 1200, upper = 32768 * 8 + 8400;
  const double working_set = 1e6 + 4e5 * thread_count();
  out.bytes = 1.05 * (out.leaves * leaf + (8 + cubes(out.surface_area, 128 * voxel, band)) * lower +
                      (8 + cubes(out.surface_area, 4096 * voxel, band)) * upper) +
              working_set;
  return out;
}

}  // namespace vug::volume

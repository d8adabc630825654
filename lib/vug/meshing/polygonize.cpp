// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/weld.h>
#include <vug/meshing/apply_moves_without_flips.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/polish_passes.h>
#include <vug/meshing/polygonize.h>
#include <vug/meshing/project.h>
#include <vug/meshing/remove_crossings.h>
#include <vug/meshing/split_quads.h>
#include <vug/volume/polygons.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

/// Exact normals and remaining distances at the rounded positions.
std::vector<SurfacePoint> sample_vertices(const mesh::Mesh& mesh, const field::Field& exact,
                                          double voxel, const PolishPasses& passes,
                                          Progress& progress) {
  const std::vector<Vec3d> points(mesh.positions.begin(), mesh.positions.end());
  std::vector<SurfacePoint> found(points.size());
  const PolishPass pass{
      5, exact, points, {8 * voxel, 0.01 * voxel}, [&](uint32_t v, std::vector<double>& inputs) {
        add_numbers(points[v], inputs);
      }};
  passes.run(
      pass,
      [&](const std::vector<uint32_t>& indices, const field::Field& local) {
        const std::vector<Vec3d> here = gathered(points, indices);
        const auto answers = SurfaceProjector(local, here, kLargestError * voxel).sample(here);
        for (size_t i = 0; i < indices.size(); ++i) found[indices[i]] = answers[i];
      },
      found, progress);
  return found;
}

PolishReport make_report(const FaceMesh& raw, const MoveResult& polished,
                         const std::vector<SurfacePoint>& found, double voxel) {
  PolishReport report;
  report.shortened_moves = polished.shortened_moves;
  for (size_t v = 0; v < found.size(); ++v) {
    report.crease_vertices += polished.on_crease[v] ? 1 : 0;
    if (std::isfinite(found[v].residual))
      report.max_residual = std::max(report.max_residual, found[v].residual / voxel);
    report.max_move =
        std::max(report.max_move, (polished.points[v] - raw.points[v]).length() / voxel);
  }
  const double squares = ordered_sum(found.size(), 0.0, [&](size_t v) {
    const double residual = found[v].residual / voxel;
    return std::isfinite(residual) ? residual * residual : 0.0;
  });
  if (!found.empty()) report.rms_residual = std::sqrt(squares / static_cast<double>(found.size()));
  return report;
}

PolygonizeResult polygonize_with(const volume::LevelSet& level_set, const field::Field* exact,
                                 const PolygonizeOptions& options, PolishCache* cache,
                                 Progress& progress) {
  const double voxel = level_set.voxel();
  const FaceMesh raw = face_mesh(volume::polygons_of(level_set, {0, options.adaptivity}), voxel);
  const bool has_work = exact && options.polish && !raw.points.empty();
  progress.begin(has_work ? "polishing the mesh" : "diagonals and normals of the mesh",
                 3 * raw.points.size() + raw.faces.size());
  MoveResult polished;
  const PolishPasses passes(cache, voxel, options);
  if (has_work)
    polished =
        apply_moves_without_flips(raw, find_targets(raw, *exact, voxel, options, passes, progress),
                                  *exact, voxel, passes, progress);
  else
    polished = {raw.points, std::vector<char>(raw.points.size(), 0), 0};

  PolygonizeResult result;
  result.mesh.triangles =
      split_quads(raw, polished.points, has_work ? exact : nullptr, voxel, passes, progress);
  result.mesh.positions.assign(polished.points.begin(), polished.points.end());
  if (has_work) remove_crossings(raw, polished, result.mesh);
  std::vector<SurfacePoint> found;
  if (exact) {
    found = sample_vertices(result.mesh, *exact, voxel, passes, progress);
    result.report = make_report(raw, polished, found, voxel);
  }
  if (options.normals) {
    result.mesh.normals = mesh::vertex_normals(result.mesh);
    for (size_t v = 0; v < found.size(); ++v)
      if (!polished.on_crease[v] && found[v].normal != Vec3d(0))
        result.mesh.normals[v] = Vec3f(found[v].normal);
  }
  result.mesh = mesh::without_unused_vertices(result.mesh);
  if (options.keys) result.keys = lattice_keys(raw, voxel);
  progress.end();
  return result;
}

}  // namespace

PolygonizeResult polygonize(const volume::LevelSet& level_set, const field::Field* exact,
                            const PolygonizeOptions& options, Progress& progress) {
  return polygonize_with(level_set, exact, options, nullptr, progress);
}

PolygonizeResult polygonize(const volume::LevelSet& level_set, const field::Field* exact,
                            const PolygonizeOptions& options, PolishCache& cache,
                            Progress& progress) {
  return polygonize_with(level_set, exact, options, &cache, progress);
}

}  // namespace vug::meshing

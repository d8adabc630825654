// SPDX-License-Identifier: Apache-2.0
#include <vug/meshing/place_on_field.h>
#include <vug/meshing/project.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vug::meshing {
namespace {

constexpr int kSearchSteps = 16;
constexpr int kBisectEvery = 3;      // Newton steps alone may creep towards one end of a bracket.
constexpr double kFlattest = 0.1;    // Cosine below which a Newton step along a line is unreliable.
constexpr double kBlindStep = 0.25;  // The step in such a case, as a share of the reach.
constexpr double kNudge = 0.5;       // The step from a point without a gradient, in tolerances.
constexpr double kOvershoot = 1.001;  // So that a step on a plane crosses the surface.

/// The search on one line, in distances from its start along its direction.
struct LineSearch {
  size_t line = 0;
  double at = 0;
  double near = 0;  ///< The last point with the sign of the start.
  double far = 0;   ///< The last point with the other sign, if `bracketed`.
  bool bracketed = false;
  bool started = false;  ///< Whether the field has had a gradient at a point.
  bool starts_inside = false;
};

/// The point of the line on the tangent plane of a point that is almost on the surface.
Vec3d on_plane(const FieldLine& line, const SurfacePoint& here) {
  const double slope = here.normal.dot(line.direction);
  if (!(slope > kFlattest) || here.residual > line.tolerance) return here.point;
  return here.point - line.direction * ((here.inside ? -here.residual : here.residual) / slope);
}

/// The place at which a search continues after its evaluation at `here`; nothing once it has left
/// its range without a zero.
std::optional<double> next_step(const LineSearch& search, const FieldLine& line,
                                const SurfacePoint& here, int step) {
  const double value = here.inside ? -here.residual : here.residual;
  const double slope = here.normal.dot(line.direction);
  const bool steep = slope > kFlattest;
  const double newton = search.at - kOvershoot * value / (steep ? slope : 1);
  if (search.bracketed) {
    const auto [low, high] = std::minmax(search.near, search.far);
    const bool usable = steep && newton > low && newton < high && step % kBisectEvery != 0;
    return usable ? newton : 0.5 * (low + high);
  }
  if (std::fabs(search.at) >= line.reach) return std::nullopt;
  const double outwards = search.starts_inside ? 1 : -1;
  const double next = steep ? newton : search.at + outwards * kBlindStep * line.reach;
  return std::clamp(next, -line.reach, line.reach);
}

}  // namespace

std::vector<PlacedPoint> place_on_field(const field::Field& field,
                                        const std::vector<FieldLine>& lines, double error) {
  std::vector<PlacedPoint> placed(lines.size());
  std::vector<LineSearch> searches(lines.size());
  std::vector<Vec3d> points(lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    placed[i] = {lines[i].start, lines[i].direction, false};
    searches[i].line = i;
    points[i] = lines[i].start;
  }
  SurfaceProjector projector(field, points, error);
  for (int step = 0; step < kSearchSteps && !searches.empty(); ++step) {
    const std::vector<SurfacePoint> found = projector.sample(points);
    size_t left = 0;
    for (size_t k = 0; k < searches.size(); ++k) {
      LineSearch search = searches[k];
      const FieldLine& line = lines[search.line];
      const SurfacePoint& here = found[k];
      const double tolerance = std::max(line.tolerance, projector.resolution());
      if (!std::isfinite(here.residual)) {  // e.g. exactly on the face of a box
        search.at += kNudge * tolerance;
        points[left] = line.start + line.direction * search.at;
        searches[left++] = search;
        continue;
      }
      if (!search.started) search.starts_inside = here.inside;
      search.started = true;
      const bool crossed = here.inside != search.starts_inside;
      (crossed ? search.far : search.near) = search.at;
      search.bracketed = search.bracketed || crossed;
      const bool jump = search.bracketed && std::fabs(search.far - search.near) <= tolerance;
      if (here.residual <= tolerance || jump) {
        placed[search.line] = {on_plane(line, here), here.normal, true};
        continue;
      }
      const std::optional<double> next = next_step(search, line, here, step);
      if (!next) continue;
      search.at = *next;
      points[left] = line.start + line.direction * search.at;
      searches[left++] = search;
    }
    searches.resize(left);
    points.resize(left);
  }
  return placed;
}

}  // namespace vug::meshing

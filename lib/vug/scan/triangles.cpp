// SPDX-License-Identifier: Apache-2.0
// Openings of a wall by large triangles between its points.
#include <vug/base/median.h>
#include <vug/scan/opening_extraction.h>
#include <vug/scan/openings.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::scan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

/// The wall's points on the plane, at most one per pixel, since triangles of nearly coincident
/// points carry no information.
std::vector<Kernel::Point_2> wall_points(const PointCloud& cloud, const RangeImage& range,
                                         const SurfaceMap& map) {
  std::vector<Kernel::Point_2> out;
  Mask taken(range.width, range.height);
  for (const Vec3d& position : cloud.positions) {
    const Vec3d p = range.frame.local(position);
    const double x = std::floor(p.x / range.pixel), y = std::floor(p.y / range.pixel);
    if (!(x >= 0 && y >= 0 && x < range.width && y < range.height)) continue;
    const size_t pixel = range.index(static_cast<int>(x), range.height - 1 - static_cast<int>(y));
    // Points ignored by the range image are not part of the facade.
    const double before = p.z - map.wall(pixel).at({p.x, p.y});
    if (taken.on[pixel] || range.count[pixel] == 0 || before < -map.set_back || before > 0.5)
      continue;
    taken.on[pixel] = 1;
    out.emplace_back(p.x, p.y);
  }
  return out;
}

double perimeter(const Triangulation::Face& face) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += std::sqrt(
        CGAL::squared_distance(face.vertex(i)->point(), face.vertex((i + 1) % 3)->point()));
  return sum;
}

/// False for triangles over concave parts of the facade's rim.
bool inside(const Triangulation::Face& face, const RangeImage& range, const SurfaceMap& map) {
  const Kernel::Point_2 middle =
      CGAL::centroid(face.vertex(0)->point(), face.vertex(1)->point(), face.vertex(2)->point());
  const int x = std::clamp(static_cast<int>(middle.x() / range.pixel), 0, range.width - 1);
  const int y = std::clamp(range.height - 1 - static_cast<int>(middle.y() / range.pixel), 0,
                           range.height - 1);
  return map.surface[range.index(x, y)] != Surface::outside;
}

/// Turns on the pixels whose centres are inside the triangle.
void draw(const Triangulation::Face& face, const RangeImage& range, Mask& mask) {
  std::array<Vec2d, 3> corner;  // In pixels, y down.
  for (int i = 0; i < 3; ++i) {
    const Kernel::Point_2& p = face.vertex(i)->point();
    corner[static_cast<size_t>(i)] = {p.x() / range.pixel, range.height - p.y() / range.pixel};
  }
  const auto [low, high] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
  const int first = std::max(0, static_cast<int>(std::ceil(low - 0.5)));
  const int last = std::min(mask.height - 1, static_cast<int>(std::floor(high - 0.5)));
  for (int y = first; y <= last; ++y) {
    double left = kInfinity, right = -kInfinity;
    for (size_t i = 0; i < 3; ++i) {
      const Vec2d &a = corner[i], &b = corner[(i + 1) % 3];
      const double at = y + 0.5;
      if ((a.y < at && b.y < at) || (a.y > at && b.y > at) || a.y == b.y) continue;
      const double x = a.x + (b.x - a.x) * (at - a.y) / (b.y - a.y);
      left = std::min(left, x), right = std::max(right, x);
    }
    const int begin = std::max(0, static_cast<int>(std::ceil(left - 0.5)));
    const int end = std::min(mask.width - 1, static_cast<int>(std::floor(right - 0.5)));
    for (int x = begin; x <= end; ++x) mask.on[mask.index(x, y)] = 1;
  }
}

}  // namespace

std::vector<Opening> openings_by_triangles(const PointCloud& cloud, const RangeImage& range,
                                           const SurfaceMap& map, const OpeningOptions& options) {
  require_valid(options);
  const std::vector<Kernel::Point_2> points = wall_points(cloud, range, map);
  const Triangulation triangulation(points.begin(), points.end());
  std::vector<double> perimeters;
  for (const auto& face : triangulation.finite_face_handles())
    perimeters.push_back(perimeter(*face));
  if (perimeters.empty()) return {};
  const double most = options.min_perimeter * median(std::move(perimeters));
  Mask open(range.width, range.height);
  for (const auto& face : triangulation.finite_face_handles())
    if (perimeter(*face) > most && inside(*face, range, map)) draw(*face, range, open);
  for (size_t i = 0; i < map.surface.size(); ++i)
    if (map.surface[i] == Surface::outside) open.on[i] = 0;
  // Here walls are as narrow as their points, not widened by inpainting and closing.
  if (options.tidy)
    open =
        closed(open, closing_radius(std::max(0.0, options.max_bar_width - options.closing), range));
  return extract_openings(open, range, map, options);
}

}  // namespace vug::scan

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/median.h>
#include <vug/base/parallel.h>
#include <vug/scan/bins.h>
#include <vug/scan/footprint.h>
#include <vug/scan/inpaint.h>
#include <vug/scan/range_image.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::scan {
namespace {

/// Points within this many tolerances of a wall determine the extent of the facade: walls bow.
constexpr double kBend = 3;

/// Projections of the points between the two distances from the plane.
std::vector<Vec2d> within_limits(const PointCloud& cloud, const PlaneFrame& frame,
                                 const RangeOptions& options) {
  return on_plane(cloud, frame,
                  [&](double z) { return z <= options.before && z >= -options.behind; });
}

/// Projections of the points near the plane or one of the walls parallel to it.
std::vector<Vec2d> near_walls(const PointCloud& cloud, const PlaneFit& plane) {
  return on_plane(cloud, plane.frame, [&](double z) {
    return std::any_of(plane.walls.begin(), plane.walls.end(),
                       [&](double wall) { return std::fabs(z - wall) <= kBend * plane.tolerance; });
  });
}

void require_range_options(const RangeOptions& options) {
  const auto refuse = [](const char* message) { throw Error(ErrorCode::bad_input, message); };
  if (!(options.pixel > 0 && std::isfinite(options.pixel)))
    refuse("the pixel size of a range image must be above 0");
  if (!(options.before >= 0 && options.behind >= 0))
    refuse("the depth limits before and behind the plane must not be negative");
  if (!std::isfinite(options.inpaint_radius)) refuse("the inpainting distance must be finite");
}

/// The pixel that contains a position in pixel units, or -1. Points at the border of the raster may
/// lie beyond it by rounding.
int place(double at, int size) {
  constexpr double kSlack = 1e-3;
  if (!(at >= -kSlack && at <= size + kSlack)) return -1;
  return static_cast<int>(std::clamp(std::floor(at), 0.0, size - 1.0));
}

/// The depths of the points in each pixel: those of pixel p are begin[p] to begin[p + 1].
struct PixelDepths {
  std::vector<uint32_t> begin;
  std::vector<float> depths;
};

PixelDepths pixel_depths(const PointCloud& cloud, const RangeImage& image,
                         const RangeOptions& options) {
  PixelDepths out;
  const auto visit = [&](const auto& take) {
    for (const Vec3d& position : cloud.positions) {
      const Vec3d p = image.frame.local(position);
      const int x = place(p.x / image.pixel, image.width);
      const int y = place(p.y / image.pixel, image.height);
      if (x >= 0 && y >= 0 && p.z <= options.before && p.z >= -options.behind)
        take(image.index(x, image.height - 1 - y), static_cast<float>(p.z));
    }
  };
  out.begin.assign(image.pixel_count() + 1, 0);
  visit([&](size_t pixel, float) { ++out.begin[pixel + 1]; });
  for (size_t p = 0; p < image.pixel_count(); ++p) out.begin[p + 1] += out.begin[p];
  out.depths.resize(out.begin.back());
  // Filling moves each start to its end, which is the start of the next pixel.
  visit([&](size_t pixel, float depth) { out.depths[out.begin[pixel]++] = depth; });
  for (size_t p = image.pixel_count(); p > 0; --p) out.begin[p] = out.begin[p - 1];
  out.begin[0] = 0;
  return out;
}

void take_depths(RangeImage& image, PixelDepths per_pixel, DepthStatistic which) {
  parallel_for(
      image.pixel_count(),
      [&](size_t p) {
        const auto from = per_pixel.depths.begin() + per_pixel.begin[p];
        const auto to = per_pixel.depths.begin() + per_pixel.begin[p + 1];
        image.count[p] = static_cast<uint16_t>(std::min<std::ptrdiff_t>(to - from, UINT16_MAX));
        if (from == to) return;
        const auto at = which == DepthStatistic::nearest ? to - 1 : from + (to - from) / 2;
        std::nth_element(from, at, to);
        image.depth[p] = *at;
      },
      4096);
}

}  // namespace

double spacing(const PointCloud& cloud, const PlaneFrame& frame, const RangeOptions& options) {
  const std::vector<Vec2d> points = within_limits(cloud, frame, options);
  if (points.empty()) throw Error(ErrorCode::bad_input, "the cloud has no points near the plane");
  constexpr uint32_t kEnough = 8;  // Points per bin for a reliable density estimate.
  for (double side = 0.05;; side *= 2) {
    std::vector<uint32_t> counts = bin_points(points, side).counts;
    const size_t bins = counts.size();
    const uint32_t middle = median(std::move(counts));
    if (middle >= kEnough || bins <= 4) return side / std::sqrt(middle);
  }
}

RangeImage range_image(const PointCloud& cloud, const PlaneFit& plane,
                       const RangeOptions& range_options) {
  require_range_options(range_options);
  RangeOptions options = range_options;
  options.before += std::max(0.0, plane.walls.back());
  options.behind -= std::min(0.0, plane.walls.front());
  const std::vector<Vec2d> near = near_walls(cloud, plane);
  if (near.empty()) throw Error(ErrorCode::bad_input, "the cloud has no points near the plane");
  const Imath::Box2d box = extent(near);
  // The last pixel contains the last point.
  const double wide = std::floor(box.size().x / options.pixel) + 1;
  const double high = std::floor(box.size().y / options.pixel) + 1;
  constexpr double kPixelBytes = 2 * sizeof(uint32_t) + 2 * sizeof(float) + sizeof(uint16_t);
  require_memory(wide * high * kPixelBytes + static_cast<double>(cloud.size()) * sizeof(float),
                 options.memory, "the range image", "use larger pixels");
  constexpr int kMostPixels = std::numeric_limits<int>::max() / 2;
  if (std::max(wide, high) > kMostPixels)
    throw Error(ErrorCode::too_large, "the range image has too many pixels on a side", {},
                "use larger pixels");
  RangeImage image;
  image.width = static_cast<int>(wide), image.height = static_cast<int>(high);
  image.pixel = options.pixel;
  image.frame = plane.frame;
  image.frame.origin = plane.frame.world({box.min.x, box.min.y, 0});
  const size_t pixels = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
  image.depth.assign(pixels, std::numeric_limits<float>::quiet_NaN());
  image.count.assign(pixels, 0);
  take_depths(image, pixel_depths(cloud, image, options), options.depth);
  // In a regular grid every position is within 0.71 spacings of a point; scans are less regular.
  const double apart = options.inpaint_radius < 0 ? 1.2 * spacing(cloud, plane.frame, options)
                                                  : options.inpaint_radius;
  inpaint(image, std::min(apart / options.pixel, wide + high));
  return image;
}

}  // namespace vug::scan

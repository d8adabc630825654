// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/fit/evidence/clusters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vug::fit {
namespace {

using Point = std::array<float, 4>;

double distance(const Point& a, const Point& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// Pixels as feature vectors; holes in the depth get a value far from all depths.
std::vector<Point> points_of(const Planes& planes, double depth_scale) {
  constexpr float kHole = 100;
  std::vector<Point> out(planes.pixels(), Point{});
  for (size_t i = 0; i < out.size(); ++i)
    for (size_t c = 0; c < std::min<size_t>(4, planes.count()); ++c) {
      const float value = planes.planes[c][i];
      out[i][c] = !std::isfinite(value) ? kHole
                  : c < 3               ? value
                                        : value * static_cast<float>(depth_scale);
    }
  return out;
}

size_t nearest(const std::vector<Point>& centers, const Point& point) {
  size_t best = 0;
  for (size_t k = 1; k < centers.size(); ++k)
    if (distance(centers[k], point) < distance(centers[best], point)) best = k;
  return best;
}

/// k-means++: each new centre is drawn with a probability proportional to the squared distance from
/// the nearest existing one.
std::vector<Point> initial_centers(const std::vector<Point>& points, int count, RandomKey key) {
  RandomStream stream(key);
  std::vector<Point> out = {points[stream.below(static_cast<uint32_t>(points.size()))]};
  std::vector<double> away(points.size(), std::numeric_limits<double>::infinity());
  while (static_cast<int>(out.size()) < count) {
    double sum = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      away[i] = std::min(away[i], distance(points[i], out.back()));
      sum += away[i];
    }
    if (!(sum > 0)) break;  // No further colours.
    double aim = stream.uniform() * sum;
    size_t i = 0;
    while (i + 1 < points.size() && (aim -= away[i]) >= 0) ++i;
    while (away[i] == 0) i = i > 0 ? i - 1 : points.size() - 1;
    out.push_back(points[i]);
  }
  return out;
}

struct Clustering {
  std::vector<Point> centers;
  double error = 0;  ///< Sum of the squared distances of the pixels from their centres.
};

/// k-means from one set of start centres; reduced row by row, so that sums do not depend on the
/// threads.
Clustering k_means(const std::vector<Point>& points, size_t width, int rounds,
                   std::vector<Point> centers) {
  struct Sum {
    std::array<std::array<double, 5>, kMaxLanes> of{};  ///< Four coordinates and a count.
    double error = 0;
  };
  const auto add = [](Sum a, const Sum& b) {
    for (size_t k = 0; k < a.of.size(); ++k)
      for (size_t c = 0; c < 5; ++c) a.of[k][c] += b.of[k][c];
    a.error += b.error;
    return a;
  };
  Clustering out;
  for (int round = 0; round < rounds; ++round) {
    const Sum sum = ordered_reduce(
        points.size() / width, Sum{},
        [&](size_t y) {
          Sum row;
          for (size_t i = y * width; i < (y + 1) * width; ++i) {
            const size_t at = nearest(centers, points[i]);
            auto& of = row.of[at];
            for (size_t c = 0; c < 4; ++c) of[c] += points[i][c];
            ++of[4];
            row.error += distance(centers[at], points[i]);
          }
          return row;
        },
        add, 16);
    for (size_t k = 0; k < centers.size(); ++k)
      for (size_t c = 0; c < 4 && sum.of[k][4] > 0; ++c)
        centers[k][c] = static_cast<float>(sum.of[k][c] / sum.of[k][4]);
    out.error = sum.error;
  }
  out.centers = std::move(centers);
  return out;
}

}  // namespace

std::vector<uint8_t> cluster(const Planes& planes, const ClusterOptions& options, RandomKey key) {
  if (options.clusters < 1 || options.clusters > kMaxLanes || planes.pixels() == 0)
    throw Error(ErrorCode::bad_input,
                "invalid clustering: needs 1 to 8 clusters and a picture with pixels");
  const std::vector<Point> points = points_of(planes, options.depth_scale);
  Clustering best;
  for (int attempt = 0; attempt < std::max(1, options.attempts); ++attempt) {
    Clustering found =
        k_means(points, static_cast<size_t>(planes.width), options.rounds,
                initial_centers(points, options.clusters, key.at(static_cast<uint64_t>(attempt))));
    if (attempt == 0 || found.error < best.error) best = std::move(found);
  }
  std::vector<Point>& centers = best.centers;
  std::stable_sort(centers.begin(), centers.end(),
                   [](const Point& a, const Point& b) { return a[0] < b[0]; });
  std::vector<uint8_t> out(points.size());
  parallel_for(
      points.size(), [&](size_t i) { out[i] = static_cast<uint8_t>(nearest(centers, points[i])); },
      4096);
  return out;
}

}  // namespace vug::fit

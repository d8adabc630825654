// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/fit/evidence/box_filter.h>
#include <vug/fit/evidence/features.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::fit {
namespace {

/// Standard deviation from the means of values and of their squares.
Plane deviation(const Plane& mean, const Plane& mean_square) {
  Plane out(mean_square);
  for (size_t i = 0; i < out.size(); ++i)
    out[i] = std::sqrt(std::max(0.0f, out[i] - mean[i] * mean[i]));
  return out;
}

template <class Value>
Plane each_place(const Planes& planes, const Value& value) {
  Plane out;
  out.reserve(planes.pixels());
  for (int y = 0; y < planes.height; ++y)
    for (int x = 0; x < planes.width; ++x) out.push_back(static_cast<float>(value(x, y)));
  return out;
}

Plane shifted(const Planes& like, const Plane& plane, int dx, int dy) {
  return each_place(like, [&](int x, int y) {
    const auto from_x = static_cast<size_t>(std::clamp(x + dx, 0, like.width - 1));
    const auto from_y = static_cast<size_t>(std::clamp(y + dy, 0, like.height - 1));
    return plane[from_y * static_cast<size_t>(like.width) + from_x];
  });
}

/// Adds samples of a blurred plane from the left, right, above and below.
void add_surroundings(Planes& out, const Plane& plane, int distance) {
  for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
    out.planes.push_back(shifted(out, plane, dx * distance, dy * distance));
}

/// The function f in the definition of L*a*b*.
double cube_root(double t) {
  constexpr double kDelta = 6.0 / 29;
  return t > kDelta * kDelta * kDelta ? maths::pow(t, 1.0 / 3)
                                      : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace

Planes to_lab(const image::Image& linear) {
  const image::Image rgb = linear.select({"R", "G", "B"});
  Planes out{rgb.width, rgb.height, std::vector<Plane>(3, Plane(rgb.pixel_count()))};
  parallel_for(
      rgb.pixel_count(),
      [&](size_t i) {
        // Non-finite values count as black.
        const auto light = [&](size_t c) {
          const float v = rgb.pixels[3 * i + c];
          return std::isfinite(v) ? static_cast<double>(v) : 0.0;
        };
        const double r = light(0), g = light(1), b = light(2);
        // IEC 61966-2-1; white is (0.9505, 1, 1.089).
        const double x = cube_root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
        const double y = cube_root(0.2126 * r + 0.7152 * g + 0.0722 * b);
        const double z = cube_root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
        out.planes[0][i] = static_cast<float>(116 * y - 16);
        out.planes[1][i] = static_cast<float>(500 * (x - y));
        out.planes[2][i] = static_cast<float>(200 * (y - z));
      },
      1024);
  return out;
}

Planes high_pass(const Planes& planes) {
  Planes out = planes;
  for (Plane& plane : out.planes)
    plane = difference(
        plane, BoxFilter(planes.width, planes.height, plane).mean(std::max(1, planes.height / 10)));
  return out;
}

Planes features(const image::Image& linear) {
  Planes out = to_lab(linear);
  const int unit = box_unit(out.height);
  const std::vector<Plane> lab = out.planes;
  std::vector<Plane>& all = out.planes;
  const auto boxes = [&](const Plane& plane) { return BoxFilter(out.width, out.height, plane); };
  const Plane& lightness = lab[0];
  const BoxFilter light = boxes(lightness);
  for (const Plane& plane : lab) {
    const BoxFilter means = boxes(plane);
    const Plane near = means.mean(3 * unit), whole = means.whole(), rows = means.rows(unit);
    all.push_back(means.mean(unit));
    all.push_back(near);
    all.push_back(means.mean(8 * unit));
    all.push_back(whole);
    all.push_back(difference(rows, whole));
    all.push_back(difference(means.columns(unit), whole));
    all.push_back(difference(near, rows));
  }
  const BoxFilter squares = boxes(squared(lightness));
  for (const int half : {unit, 3 * unit, 8 * unit})
    all.push_back(deviation(light.mean(half), squares.mean(half)));
  for (const bool along_x : {true, false}) {
    const BoxFilter found = boxes(central_differences(out.width, out.height, lightness, along_x));
    all.push_back(found.mean(unit));
    all.push_back(found.mean(4 * unit));
    all.push_back(found.rows(unit));
    all.push_back(found.columns(unit));
  }
  const Plane soft = light.mean(2 * unit);
  for (const int distance : {6 * unit, 14 * unit}) add_surroundings(out, soft, distance);
  all.push_back(
      each_place(out, [&](int x, int) { return std::fabs((x + 0.5) / out.width - 0.5); }));
  all.push_back(each_place(out, [&](int, int y) { return (y + 0.5) / out.height; }));
  return out;
}

Planes context_features(const Planes& maps) {
  const int unit = box_unit(maps.height);
  Planes out{maps.width, maps.height, {}};
  for (const Plane& map : maps.planes) {
    std::vector<Plane>& all = out.planes;
    const BoxFilter means(maps.width, maps.height, map);
    const Plane soft = means.mean(2 * unit);
    all.push_back(map);
    all.push_back(soft);
    all.push_back(means.mean(8 * unit));
    all.push_back(means.rows(unit));
    all.push_back(means.columns(unit));
    all.push_back(means.mean(out.width, 8 * unit));
    all.push_back(means.mean(1, 12 * unit));
    all.push_back(means.mean(12 * unit, 1));
    add_surroundings(out, soft, 8 * unit);
    add_surroundings(out, soft, 20 * unit);
  }
  return out;
}

size_t feature_count() {
  static const size_t count = features(image::Image(1, 1, {"R", "G", "B"})).count();
  return count;
}

size_t context_count() {
  static const size_t count = context_features({1, 1, {{0}}}).count();
  return count;
}

}  // namespace vug::fit

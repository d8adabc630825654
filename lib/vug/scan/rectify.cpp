// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/scan/rectify.h>

#include <fmt/format.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

/// Translation and scale that centre the points at the origin with a mean distance of sqrt(2).
Eigen::Matrix3d normalisation(const FourPoints& points) {
  Vec2d middle(0, 0);
  for (const Vec2d& p : points) middle += p / 4.0;
  double away = 0;
  for (const Vec2d& p : points) away += (p - middle).length() / 4;
  const double scale = away > 0 ? std::sqrt(2.0) / away : 1;
  Eigen::Matrix3d out;
  out << scale, 0, -scale * middle.x, 0, scale, -scale * middle.y, 0, 0, 1;
  return out;
}

Vec2d mapped(const Eigen::Matrix3d& m, const Vec2d& p) {
  const Eigen::Vector3d v = m * Eigen::Vector3d(p.x, p.y, 1);
  return {v.x() / v.z(), v.y() / v.z()};
}

/// Twice the signed area of the triangle, positive if a, b, c are clockwise with y down.
double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) { return (b - a).cross(c - b); }

/// The smallest turn of the four corners, relative to the square over the longest side.
double min_turn(const FourPoints& p, double sign) {
  double smallest = kInfinity, longest = 0;
  for (size_t i = 0; i < 4; ++i) {
    smallest = std::min(smallest, sign * turn(p[i], p[(i + 1) % 4], p[(i + 2) % 4]));
    longest = std::max(longest, (p[(i + 1) % 4] - p[i]).length2());
  }
  return longest > 0 ? smallest / longest : -1;
}

void require_convex(const FourPoints& corners) {
  for (const Vec2d& p : corners)
    if (!(std::isfinite(p.x) && std::isfinite(p.y)))
      throw Error(ErrorCode::bad_input, "the corners of a facade must be finite");
  constexpr double kFlat = 1e-6;
  if (min_turn(corners, 1) > kFlat) return;
  if (min_turn(corners, -1) > kFlat)
    throw Error(ErrorCode::bad_input, "the corners are in counter-clockwise order", {},
                "give them clockwise: upper left, upper right, lower right, lower left");
  throw Error(ErrorCode::bad_input, "the corners do not form a convex quadrangle", {},
              "give them clockwise: upper left, upper right, lower right, lower left");
}

FourPoints corners_of(double width, double height) {
  return {Vec2d(0, 0), Vec2d(width, 0), Vec2d(width, height), Vec2d(0, height)};
}

double length(const FourPoints& p, size_t a, size_t b) { return (p[b] - p[a]).length(); }

/// Corners may lie outside of the photo, where the result is empty.
void require_near(const FourPoints& corners, const image::Image& photo) {
  for (const Vec2d& p : corners)
    if (p.x < -photo.width || p.y < -photo.height || p.x > 2.0 * photo.width ||
        p.y > 2.0 * photo.height)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the corner {},{} lies far outside of the photo, which has {} x {} "
                              "pixels",
                              p.x, p.y, photo.width, photo.height),
                  {}, "pixels count from its upper left corner");
}

}  // namespace

image::Homography homography(const FourPoints& from, const FourPoints& to) {
  for (const FourPoints* points : {&from, &to})
    for (size_t i = 0; i < 4; ++i) {
      const Vec2d &a = (*points)[i], &b = (*points)[(i + 1) % 4], &c = (*points)[(i + 2) % 4];
      const double span = std::max((b - a).length2(), (c - a).length2());
      if (!(std::fabs(turn(a, b, c)) > 1e-9 * span) || !std::isfinite(span))
        throw Error(ErrorCode::bad_input, "three of the four points are collinear", {},
                    "choose the corners of a rectangle on the facade");
    }
  const Eigen::Matrix3d before = normalisation(from), after = normalisation(to);
  Eigen::Matrix<double, 8, 8> rows;
  Eigen::Matrix<double, 8, 1> right;
  for (int i = 0; i < 4; ++i) {
    const Vec2d p = mapped(before, from[static_cast<size_t>(i)]);
    const Vec2d q = mapped(after, to[static_cast<size_t>(i)]);
    rows.row(2 * i) << p.x, p.y, 1, 0, 0, 0, -q.x * p.x, -q.x * p.y;
    rows.row(2 * i + 1) << 0, 0, 0, p.x, p.y, 1, -q.y * p.x, -q.y * p.y;
    right[2 * i] = q.x, right[2 * i + 1] = q.y;
  }
  const Eigen::Matrix<double, 8, 1> h = rows.fullPivLu().solve(right);
  Eigen::Matrix3d normal;
  normal << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1;
  Eigen::Matrix3d all = after.inverse() * normal * before;
  all /= all.cwiseAbs().maxCoeff();
  image::Homography out;
  for (int i = 0; i < 9; ++i) out.m[static_cast<size_t>(i)] = all(i / 3, i % 3);
  return out;
}

double estimate_aspect(const FourPoints& corners, int photo_width, int photo_height) {
  require_convex(corners);
  // From the unit square, with the origin at the photo's centre and half of its longer side as the
  // unit.
  const double unit = std::max(photo_width, photo_height) / 2.0;
  FourPoints seen = corners;
  for (Vec2d& p : seen) p = (p - Vec2d(photo_width / 2.0, photo_height / 2.0)) / unit;
  const auto& m = homography(corners_of(1, 1), seen).m;
  const Eigen::Vector3d a(m[0], m[3], m[6]), b(m[1], m[4], m[7]);
  // The columns are the sides of the rectangle in camera axes up to the focal length f; they are
  // orthogonal: (a.x b.x + a.y b.y) / f^2 + a.z b.z = 0.
  const double across = a.x() * b.x() + a.y() * b.y(), along = a.z() * b.z();
  const double focal2 = along != 0 ? -across / along : 0;
  constexpr double kShortest = 0.3, kLongest = 20;  // In halves of the photo.
  if (focal2 > kShortest * kShortest && focal2 < kLongest * kLongest) {
    const auto length2 = [&](const Eigen::Vector3d& v) {
      return (v.x() * v.x() + v.y() * v.y()) / focal2 + v.z() * v.z();
    };
    return std::sqrt(length2(a) / length2(b));
  }
  return (length(corners, 0, 1) + length(corners, 3, 2)) /
         (length(corners, 0, 3) + length(corners, 1, 2));
}

RectifiedPhoto rectify(const image::Image& photo, const FourPoints& corners,
                       const RectifyOptions& options) {
  require_convex(corners);
  require_near(corners, photo);
  const bool given = options.width != 0 || options.height != 0;
  for (const double side : {options.width, options.height})
    if (given && !(side > 0 && std::isfinite(side)))
      throw Error(ErrorCode::bad_input, "a rectified picture needs a width and a height above 0");
  if (!(options.pixel >= 0 && std::isfinite(options.pixel)))
    throw Error(ErrorCode::bad_input, "the pixel size of a rectified picture must not be negative");
  RectifiedPhoto out;
  out.height = given ? options.height : 1;
  out.width = given ? options.width : estimate_aspect(corners, photo.width, photo.height);
  const double finest =
      std::min(out.width / std::max(length(corners, 0, 1), length(corners, 3, 2)),
               out.height / std::max(length(corners, 0, 3), length(corners, 1, 2)));
  const double pixel = options.pixel > 0 ? options.pixel : finest;
  const double wide = std::max(1.0, std::round(out.width / pixel));
  const double high = std::max(1.0, std::round(out.height / pixel));
  require_memory(wide * high * 4 * static_cast<double>(photo.channels.size()), options.memory,
                 "the rectified picture", "use larger pixels");
  if (std::max(wide, high) > 1e6)
    throw Error(ErrorCode::too_large, "the rectified picture has too many pixels on a side", {},
                "use larger pixels");
  out.picture = image::warped(photo, homography(corners, corners_of(wide, high)),
                              static_cast<int>(wide), static_cast<int>(high));
  return out;
}

image::Image overlay_photo(const RangeImage& range, const image::Image& photo,
                           const FourPoints& in_photo, const FourPoints& on_facade,
                           uint64_t memory) {
  require_memory(static_cast<double>(range.pixel_count()) *
                     static_cast<double>((2 * photo.channels.size() + 2) * sizeof(float)),
                 memory, fmt::format("a picture of {} x {} pixels", range.width, range.height),
                 "use a range image with larger pixels");
  require_near(in_photo, photo);
  FourPoints pixels = on_facade;
  for (Vec2d& p : pixels) p = {p.x / range.pixel, range.height - p.y / range.pixel};
  const image::Image colours =
      image::warped(photo, homography(in_photo, pixels), range.width, range.height);
  std::vector<std::string> channels = colours.channels;
  channels.insert(channels.end(), {"depth", "count"});
  image::Image out(range.width, range.height, channels);
  const size_t count = colours.channels.size();
  for (size_t p = 0; p < range.pixel_count(); ++p) {
    std::copy_n(colours.pixels.data() + p * count, count, out.pixels.data() + p * (count + 2));
    out.pixels[p * (count + 2) + count] = range.depth[p];
    out.pixels[p * (count + 2) + count + 1] = range.count[p];
  }
  return out;
}

image::Image overlay_photo(const RangeImage& range, const image::Image& photo, uint64_t memory) {
  const double wide = range.metres_wide(), high = range.metres_high();
  return overlay_photo(range, photo, corners_of(photo.width, photo.height),
                       {Vec2d(0, high), Vec2d(wide, high), Vec2d(wide, 0), Vec2d(0, 0)}, memory);
}

}  // namespace vug::scan

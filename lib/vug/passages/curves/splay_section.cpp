// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/median.h>
#include <vug/passages/curves/splay_section.h>
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::passages {
namespace {

constexpr int kCorners = 48;

struct Hit {
  double angle, radius;
};

std::vector<Hit> hits(const std::vector<Vec3d>& splays, const Vec3d& station, const Frame& frame) {
  std::vector<Hit> out;
  for (const Vec3d& end : splays) {
    const Vec3d offset = end - station;
    const double u = offset.dot(frame.right), v = offset.dot(frame.up);
    const double across = std::sqrt(u * u + v * v);
    if (across > 0.05 && across * across >= 0.5 * offset.length2())
      out.push_back({maths::atan2(v, u), across});
  }
  if (out.empty()) return out;
  std::vector<double> radii;
  for (const Hit& hit : out) radii.push_back(hit.radius);
  const double usual = median(std::move(radii));
  std::erase_if(out, [&](const Hit& hit) { return hit.radius > 3 * usual; });
  std::sort(out.begin(), out.end(), [](const Hit& a, const Hit& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.radius < b.radius;
  });
  // Hits in nearly the same direction: their mean.
  std::vector<Hit> apart;
  int merged = 1;
  for (const Hit& hit : out) {
    if (!apart.empty() && hit.angle - apart.back().angle < 0.02) {
      ++merged;
      apart.back().radius += (hit.radius - apart.back().radius) / merged;
      continue;
    }
    merged = 1;
    apart.push_back(hit);
  }
  return apart;
}

double ellipse_radius(const Walls& walls, double angle) {
  const double c = maths::cos(angle), s = maths::sin(angle);
  const double a = std::max(c > 0 ? walls.right : walls.left, 0.05);
  const double b = std::max(s > 0 ? walls.up : walls.down, 0.05);
  return 1 / std::sqrt(c * c / (a * a) + s * s / (b * b));
}

/// Adds points of the ellipse in gaps of more than 90 degrees.
std::vector<Hit> without_wide_gaps(const std::vector<Hit>& sorted, const Walls& walls) {
  std::vector<Hit> out;
  for (size_t i = 0; i < sorted.size(); ++i) {
    out.push_back(sorted[i]);
    const double next = i + 1 < sorted.size() ? sorted[i + 1].angle : sorted[0].angle + 2 * kPi;
    const double gap = next - sorted[i].angle;
    if (gap <= 0.5 * kPi + 1e-9) continue;
    const int pieces = static_cast<int>(std::ceil(gap / (kPi / 6)));
    for (int k = 1; k < pieces; ++k) {
      const double angle = sorted[i].angle + gap * k / pieces;
      out.push_back({angle, ellipse_radius(walls, angle)});
    }
  }
  return out;
}

/// The slope at each hit of the monotone periodic cubic (fritsch1984monotone): the harmonic mean of
/// the slopes on both sides, 0 at extrema.
std::vector<double> monotone_slopes(const std::vector<Hit>& all) {
  const size_t n = all.size();
  const auto slope = [&](size_t i) {
    const Hit &a = all[i], &b = all[(i + 1) % n];
    return (b.radius - a.radius) / (b.angle + (i + 1 == n ? 2 * kPi : 0) - a.angle);
  };
  std::vector<double> out(n);
  for (size_t i = 0; i < n; ++i) {
    const double before = slope((i + n - 1) % n), after = slope(i);
    out[i] = before * after > 0 ? 2 * before * after / (before + after) : 0;
  }
  return out;
}

}  // namespace

SectionPtr splay_section(const std::vector<Vec3d>& splays, const Vec3d& station, const Frame& frame,
                         const Walls& walls) {
  const std::vector<Hit> measured = hits(splays, station, frame);
  if (measured.size() < 4) return nullptr;
  double widest = 0;
  for (size_t i = 0; i < measured.size(); ++i)
    widest = std::max(
        widest, (i + 1 < measured.size() ? measured[i + 1].angle : measured[0].angle + 2 * kPi) -
                    measured[i].angle);
  if (widest > 1.5 * kPi) return nullptr;
  const std::vector<Hit> all = without_wide_gaps(measured, walls);
  const std::vector<double> slopes = monotone_slopes(all);
  std::vector<Vec2d> outline;
  for (size_t i = 0; i < all.size(); ++i) {
    const size_t next = (i + 1) % all.size();
    const double span = all[next].angle + (next == 0 ? 2 * kPi : 0) - all[i].angle;
    const int pieces = std::max(1, static_cast<int>(std::lround(kCorners * span / (2 * kPi))));
    for (int k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, u = 1 - t;
      const double radius = all[i].radius * u * u * (1 + 2 * t) +
                            all[next].radius * t * t * (3 - 2 * t) +
                            span * (slopes[i] * t * u * u - slopes[next] * t * t * u);
      const double angle = all[i].angle + span * t;
      outline.push_back(Vec2d(maths::cos(angle), maths::sin(angle)) * std::max(radius, 0.02));
    }
  }
  return polygon_section(outline);
}

}  // namespace vug::passages

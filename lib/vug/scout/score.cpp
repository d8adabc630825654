// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/quantile.h>
#include <vug/render/vectors.h>
#include <vug/scout/regions.h>
#include <vug/scout/score.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

constexpr double kJump = 1.3;       // ratio of distances at an edge
constexpr double kFarthest = 1000;  // metres: the sky counts as this far
constexpr float kCeiling = -0.5f;   // normals below this belong to a ceiling
constexpr double kBorder = 0.15;    // of the width and the height

double clamped(double x) { return std::clamp(x, 0.0, 1.0); }

double entropy(const double* shares, size_t count) {
  double sum = 0;
  for (size_t i = 0; i < count; ++i)
    if (shares[i] > 0) sum -= shares[i] * maths::log(shares[i]);
  return sum;
}

/// The logarithm of the distance of each pixel.
std::vector<double> log_distances(const View& view) {
  std::vector<double> out;
  out.reserve(view.pixels.size());
  for (const Seen& each : view.pixels)
    out.push_back(maths::log(std::clamp(static_cast<double>(each.distance), 0.01, kFarthest)));
  return out;
}

Vec2d film_position(const View& view, int x, int y) {
  return {(x + 0.5) / view.width, (y + 0.5) / view.height};
}

/// The gradient of l, in the units of film positions.
Vec2d gradient(const View& view, const std::vector<double>& l, int x, int y) {
  const int left = std::max(x - 1, 0), right = std::min(x + 1, view.width - 1);
  const int up = std::max(y - 1, 0), down = std::min(y + 1, view.height - 1);
  return {(l[view.index(right, y)] - l[view.index(left, y)]) * view.width / (right - left),
          (l[view.index(x, down)] - l[view.index(x, up)]) * view.height / (down - up)};
}

double size(const Vec2d& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

double lead_of(const Vec2d& deepest) {
  double to_third = kInfinity;
  for (const double x : {1.0 / 3, 2.0 / 3})
    for (const double y : {1.0 / 3, 2.0 / 3})
      to_third = std::min(to_third, size(deepest - Vec2d(x, y)));
  const double to_centre = size(deepest - Vec2d(0.5, 0.5));
  const auto bell = [](double d, double width) { return maths::exp(-d * d / (2 * width * width)); };
  return std::max(bell(to_third, 0.12), 0.7 * bell(to_centre, 0.1));
}

/// The terms `lines` and `balance`, which are sums over the gradient.
void add_edges(const View& view, const std::vector<double>& l, const Vec2d& deepest,
               ScoreTerms& terms) {
  double along = 0, guided = 0, all = 0, moment = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const Vec2d g = gradient(view, l, x, y);
      const double strength = size(g);
      all += strength;
      moment += strength * film_position(view, x, y).x;
      if (view.shows_sky(x, y) || view.at(x, y).normal.y < kCeiling) continue;
      const Vec2d way = deepest - film_position(view, x, y);
      const double lengths = strength * size(way);
      if (!(lengths > 0)) continue;
      const double cosine = (g.x * way.y - g.y * way.x) / lengths;  // edge: g turned by 90 degrees
      along += strength * cosine * cosine;
      guided += strength;
    }
  terms.lines = guided > 0 ? clamped((along / guided - 0.5) / 0.2) : 0;
  terms.balance = all > 0 ? clamped(1 - std::fabs(moment / all - 0.5) / 0.25) : 0;
}

double frame_of(const View& view, const std::vector<double>& l, double threshold) {
  double near[2] = {0, 0}, count[2] = {0, 0};
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const Vec2d p = film_position(view, x, y);
      const bool border = std::min({p.x, 1 - p.x, p.y, 1 - p.y}) < kBorder;
      ++count[border];
      if (l[view.index(x, y)] < threshold) ++near[border];
    }
  const double excess = near[1] / count[1] - near[0] / count[0];
  return clamped(1 - std::fabs(excess - 0.35) / 0.35);
}

/// The share of the pixels with a jump of the distance in the 3 x 3 pixels around.
double clutter(const View& view, const std::vector<double>& l) {
  const double jump = maths::log(kJump);
  size_t edges = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      double low = kInfinity, high = -kInfinity;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view.width - 1); ++u) {
          low = std::min(low, l[view.index(u, v)]);
          high = std::max(high, l[view.index(u, v)]);
        }
      if (high - low > jump) ++edges;
    }
  return static_cast<double>(edges) / static_cast<double>(view.pixels.size());
}

double sizes_of(const View& view) {
  const auto n = static_cast<double>(view.pixels.size());
  const std::vector<Region> parts =
      connected_regions(view, [](const Seen&, const Seen& a, const Seen& b) {
        if (a.object == kSky || b.object == kSky) return a.object == b.object;
        return std::max(a.distance, b.distance) <
               static_cast<float>(kJump) * std::min(a.distance, b.distance);
      });
  double sum = 0, squares = 0;
  int large = 0, small = 0;
  for (const Region& each : parts) {
    const double share = static_cast<double>(each.pixels) / n, l = maths::log(share);
    sum += l, squares += l * l;
    if (share > 0.15) ++large;
    if (share < 0.02) ++small;
  }
  const auto count = static_cast<double>(parts.size());
  const double variance = std::max(0.0, squares / count - sum * sum / (count * count));
  return clamped(std::sqrt(variance) / 1.2) * (large >= 1 && small >= 3 ? 1 : 0.5);
}

/// The face of an icosahedron, 0 to 19, to which a direction points: the nearest corner of the dual
/// dodecahedron.
size_t icosahedron_face(const Vec3f& n) {
  constexpr float kGolden = 1.618034f;
  size_t best = 0;
  float most = -2;
  size_t face = 0;
  const auto offer = [&](float x, float y, float z) {
    const float cosine = n.x * x + n.y * y + n.z * z;
    if (cosine > most) most = cosine, best = face;
    ++face;
  };
  for (const float a : {-1.0f, 1.0f})
    for (const float b : {-1.0f, 1.0f}) {
      for (const float c : {-1.0f, 1.0f}) offer(a, b, c);
      offer(0, a / kGolden, b * kGolden);
      offer(a / kGolden, b * kGolden, 0);
      offer(a * kGolden, 0, b / kGolden);
    }
  return best;
}

double directions_of(const View& view) {
  std::array<double, 20> shares{};
  double hits = 0;
  for (const Seen& each : view.pixels)
    if (each.object != kSky) ++shares[icosahedron_face(each.normal)], ++hits;
  if (hits == 0) return 0;
  for (double& share : shares) share /= hits;
  const double e = entropy(shares.data(), shares.size()) / maths::log(20.0);
  return clamped(1 - std::fabs(e - 0.75) / 0.5);
}

struct Extent {
  double pixels = 0;
  int top = 1 << 20, bottom = -1;
  bool cut = false;
};

void add_landmarks(const View& view, const Landmarks& landmarks, ScoreTerms& terms) {
  std::map<uint32_t, Extent> extents;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      Extent& one = extents[view.at(x, y).object];
      ++one.pixels;
      one.top = std::min(one.top, y), one.bottom = std::max(one.bottom, y);
      one.cut |= x == 0 || y == 0 || x == view.width - 1 || y == view.height - 1;
    }
  for (const auto& [object, extent] : extents) {
    const double share = extent.pixels / static_cast<double>(view.pixels.size());
    if (const auto weight = landmarks.weights.find(object); weight != landmarks.weights.end())
      terms.landmarks += weight->second * std::min(1.0, share / 0.02) * (extent.cut ? 0.6 : 1) / 3;
    const double height = static_cast<double>(extent.bottom - extent.top + 1) / view.height;
    if (!landmarks.known_size.count(object)) continue;
    if (extent.cut && share > 0.002) {
      terms.size_known = 0.1;  // a figure without its head or feet
      break;
    }
    if (height >= 0.03 && height <= 0.25) terms.size_known = 1;
  }
}

}  // namespace

Vec2d deepest_part(const View& view) {
  const std::vector<double> l = log_distances(view);
  const double threshold = quantile(l, 0.95);
  Vec2d sum(0, 0);
  double count = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      if (l[view.index(x, y)] >= threshold) sum += film_position(view, x, y), ++count;
  return sum / count;
}

double ScoreTerms::total() const {
  return maths::pow(depth * layers * lead, 1.0 / 3) * clear * size_known *
         (0.25 * lines + 0.2 * frame + 0.2 * landmarks + 0.15 * sizes + 0.1 * directions +
          0.1 * balance);
}

ScoreTerms score(const View& view, const Landmarks& landmarks) {
  ScoreTerms terms;
  const std::vector<double> l = log_distances(view);
  const OtsuClasses classes = otsu_classes(l);
  const Vec2d deepest = deepest_part(view);
  terms.depth = clamped((quantile(l, 0.9) - quantile(l, 0.1)) / maths::log(8.0));
  terms.layers = clamped(entropy(classes.shares.data(), 3) / maths::log(3.0) * classes.separation);
  terms.lead = lead_of(deepest);
  terms.clear = clamped(1 - (clutter(view, l) - 0.25) / 0.25);
  add_edges(view, l, deepest, terms);
  terms.frame = frame_of(view, l, classes.low);
  add_landmarks(view, landmarks, terms);
  terms.landmarks = clamped(terms.landmarks);
  terms.sizes = sizes_of(view);
  terms.directions = directions_of(view);
  return terms;
}

}  // namespace vug::scout

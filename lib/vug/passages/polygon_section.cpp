// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/numbers/scalar.h>
#include <vug/passages/polygon_edges.h>
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::abs, field::both, field::clamp, field::max, field::min, field::select, field::sign,
    field::sqrt, field::square;

/// The nearest edge so far, with its height where the point projects onto it, because the offset
/// from the nearest point has no direction on the outline itself; and the winding number.
template <class S>
class NearestEdge {
 public:
  NearestEdge(const S& u, const S& v) : u_(u), v_(v) {}
  void add(const Edge& edge) {
    const S pu = u_ - S(edge.a.x), pv = v_ - S(edge.a.y);
    const S on = (pu * S(edge.along.x) + pv * S(edge.along.y)) * S(edge.inverse);
    const S t = clamp(on, S(0.0), S(1.0));
    const S du = pu - S(edge.along.x) * t, dv = pv - S(edge.along.y) * t;
    const S d2 = square(du) + square(dv);
    const S height = pu * S(edge.normal.x) + pv * S(edge.normal.y);
    const auto within = abs(on - S(0.5)) < S(0.5);
    // Beyond an end, the offset points from the corner; its sign is that of the winding number.
    const S flip = sign(height);
    const auto nearer = d2 < least_, at_corner = d2 < S(1e-16);
    least_ = min(least_, d2);
    const S nu = S(edge.normal.x) * flip, nv = S(edge.normal.y) * flip;
    x_ = select(nearer, select(within, nu, S(select(at_corner, nu, du))), x_);
    y_ = select(nearer, select(within, nv, S(select(at_corner, nv, dv))), y_);
    winding_ = winding_ + crossing(edge, height);
  }
  /// Adds an edge to the winding number alone.
  void add_crossing(const Edge& edge) {
    const S pu = u_ - S(edge.a.x), pv = v_ - S(edge.a.y);
    winding_ = winding_ + crossing(edge, pu * S(edge.normal.x) + pv * S(edge.normal.y));
  }
  PlaneDistance<S> finish(double rounding) const {
    const S away = sqrt(least_);
    const S size = S(1.0) / max(sqrt(square(x_) + square(y_)), S(1e-18));
    const S side = select(abs(winding_) > S(0.5), S(-1.0), S(1.0));
    return {side * away - S(rounding), side * x_ * size, side * y_ * size};
  }

 private:
  /// 1 or -1 if the ray towards +u from the point crosses the edge upwards or downwards.
  S crossing(const Edge& edge, const S& height) const {
    if (edge.a.y < edge.b.y)
      return select(both(both(v_ >= S(edge.a.y), v_ < S(edge.b.y)), height < S(0.0)), S(1.0),
                    S(0.0));
    return select(both(both(v_ >= S(edge.b.y), v_ < S(edge.a.y)), height > S(0.0)), S(-1.0),
                  S(0.0));
  }

  S u_, v_, least_{1e30}, x_{0.0}, y_{0.0}, winding_{0.0};
};

class PolygonSection final : public Section {
 public:
  PolygonSection(SectionTraits traits, std::vector<Edge> edges, double rounding)
      : Section(traits), edges_(std::move(edges)), lanes_(edges_), rounding_(rounding) {}

  PlaneDistance<double> at(double u, double v) const override {
    PlaneDistance<double> out;
    sample(&u, &v, 1, [&](int, const PlaneDistance<double>& d) { out = d; });
    return out;
  }
  void distances(const Pack* u, const Pack* v, int count, Pack* out) const override {
    sample(u, v, count, [&](int i, const PlaneDistance<Pack>& d) { out[i] = d.value; });
  }
  void slopes(const Pack* u, const Pack* v, int count, PlaneDistance<Pack>* out) const override {
    sample(u, v, count, [&](int i, const PlaneDistance<Pack>& d) { out[i] = d; });
  }
  std::vector<Vec2d> outline(int count) const override;

 protected:
  void add_numbers_to(Digester& digester) const override { digester(edges_, rounding_); }

 private:
  /// Calls keep(i, distance) for each point. Some consecutive points, which are usually close to
  /// each other, share a selection of edges.
  template <class S, class Keep>
  void sample(const S* u, const S* v, int count, const Keep& keep) const {
    constexpr int kShared = 4;
    for (int begin = 0; begin < count; begin += kShared) {
      const int end = std::min(begin + kShared, count);
      if (lanes_.empty()) {
        for (int i = begin; i < end; ++i) {
          NearestEdge<S> nearest(u[i], v[i]);
          for (const Edge& edge : edges_) nearest.add(edge);
          keep(i, nearest.finish(rounding_));
        }
        continue;
      }
      const EdgeLanes::Selection near =
          lanes_.select(rectangle_around(u + begin, v + begin, end - begin));
      for (int i = begin; i < end; ++i) {
        NearestEdge<S> nearest(u[i], v[i]);
        near.visit([&](size_t n) { nearest.add(edges_[n]); },
                   [&](size_t n) { nearest.add_crossing(edges_[n]); });
        keep(i, nearest.finish(rounding_));
      }
    }
  }

  std::vector<Edge> edges_;
  EdgeLanes lanes_;
  double rounding_;
};

std::vector<Vec2d> PolygonSection::outline(int count) const {
  double length = 0;
  for (const Edge& edge : edges_) length += edge.along.length() + 2 * kPi * rounding_ / 8;
  const double step = length / std::max(count, 3);
  std::vector<Vec2d> points;
  for (size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const Edge& next = edges_[(i + 1) % edges_.size()];
    const int pieces = std::max(1, static_cast<int>(std::ceil(edge.along.length() / step)));
    for (int k = 0; k < pieces; ++k)
      points.push_back(edge.a + edge.along * (static_cast<double>(k) / pieces) +
                       edge.normal * rounding_);
    if (rounding_ <= 0) continue;
    const double turn = maths::atan2(edge.normal.cross(next.normal), edge.normal.dot(next.normal));
    if (turn <= 0) continue;
    const int turns = std::max(1, static_cast<int>(std::ceil(turn * rounding_ / step)));
    const double start = maths::atan2(edge.normal.y, edge.normal.x);
    for (int k = 0; k < turns; ++k) {
      const double angle = start + turn * k / turns;
      points.push_back(edge.b + Vec2d(maths::cos(angle), maths::sin(angle)) * rounding_);
    }
  }
  // Offsets of the edges at a concave corner cross, and end inside.
  if (rounding_ > 0)
    std::erase_if(points, [&](const Vec2d& p) { return distance(p.x, p.y) < -1e-9; });
  return points;
}

/// The polygon moved inwards: each corner goes to the intersection of its edges' parallels. Empty
/// if an edge vanishes, or if a corner is sharper than about 30 degrees and its parallels meet far
/// away.
std::vector<Vec2d> inset(const std::vector<Vec2d>& outline, double by) {
  std::vector<Vec2d> moved;
  const size_t n = outline.size();
  for (size_t i = 0; i < n; ++i) {
    const Edge before(outline[(i + n - 1) % n], outline[i]),
        after(outline[i], outline[(i + 1) % n]);
    const Vec2d middle = before.normal + after.normal;
    if (middle.length2() < 0.25) return {};
    moved.push_back(outline[i] - middle * (by * 2 / middle.length2()));
  }
  for (size_t i = 0; i < n; ++i)
    if ((moved[(i + 1) % n] - moved[i]).dot(outline[(i + 1) % n] - outline[i]) <= 0) return {};
  return moved;
}

[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Error(ErrorCode::bad_input, what, {}, hint);
}

/// The traits of the polygon, moved outwards by a radius.
SectionTraits traits_of(const std::vector<Vec2d>& polygon, double radius) {
  SectionTraits traits;
  traits.min = traits.max = polygon[0];
  for (const Vec2d& p : polygon) {
    traits.min = {std::min(traits.min.x, p.x), std::min(traits.min.y, p.y)};
    traits.max = {std::max(traits.max.x, p.x), std::max(traits.max.y, p.y)};
    traits.reach = std::max(traits.reach, p.length() + radius);
  }
  traits.min -= Vec2d(radius);
  traits.max += Vec2d(radius);
  traits.depth = 0.5 * std::min(traits.width(), traits.height());
  traits.area = 0.5 * twice_area(polygon);
  return traits;
}

}  // namespace

double twice_area(const std::vector<Vec2d>& outline) {
  double sum = 0;
  for (size_t i = 0; i < outline.size(); ++i)
    sum += outline[i].cross(outline[(i + 1) % outline.size()]);
  return sum;
}

void append_arc(std::vector<Vec2d>& outline, const Vec2d& centre, const Vec2d& radii, double from,
                double to, int count) {
  for (int i = 0; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    outline.push_back(centre + radii * Vec2d(maths::cos(angle), maths::sin(angle)));
  }
}

SectionPtr polygon_section(const std::vector<Vec2d>& outline, double rounding) {
  std::vector<Vec2d> corners;
  for (const Vec2d& p : outline) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      refuse("the outline of a section contains a coordinate that is not a finite number",
             "check the sizes of the section");
    if (corners.empty() || (p - corners.back()).length() > 1e-9) corners.push_back(p);
  }
  while (corners.size() > 1 && (corners.front() - corners.back()).length() <= 1e-9)
    corners.pop_back();
  if (corners.size() < 3 || !(twice_area(corners) > 0))
    refuse("the outline of a section must be a counterclockwise polygon of at least three corners",
           "give the section a width and a height above 0");
  std::vector<Vec2d> moved;
  double radius = std::max(rounding, 0.0);
  for (int attempt = 0; radius > 0 && moved.empty() && attempt < 8; ++attempt) {
    moved = inset(corners, radius);
    if (moved.empty()) radius *= 0.5;
  }
  if (moved.empty()) {
    moved = corners;
    radius = 0;
  }
  std::vector<Edge> edges;
  for (size_t i = 0; i < moved.size(); ++i)
    edges.emplace_back(moved[i], moved[(i + 1) % moved.size()]);
  SectionTraits traits = traits_of(moved, radius);
  const PolygonSection probe(traits, edges, radius);
  if (radius > 0) traits.area = 0.5 * twice_area(probe.outline(1024));
  traits.core = -probe.distance(0, 0);
  if (!(traits.core > 0))
    refuse("the outline of a section does not contain the axis of the passage",
           "move the outline so that it surrounds the origin");
  return std::make_shared<PolygonSection>(traits, std::move(edges), radius);
}

}  // namespace vug::passages

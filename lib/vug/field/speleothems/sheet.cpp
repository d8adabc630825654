// SPDX-License-Identifier: Apache-2.0
#include <vug/field/enclosing_ball.h>
#include <vug/field/speleothems/sheet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <type_traits>

namespace vug::field {
namespace {

/// A triangle with a radius that is linear over it.
struct Facet {
  Vec3d a, edge1, edge2;           // Corners a, a + edge1, a + edge2.
  double square1, square2, mixed;  // Products of the edges.
  double inverse1, inverse2, inverse3, inverse_area;
  double radius, rise1, rise2;  // At a; changes along the edges.

  Facet(const std::array<Vec3d, 3>& p, const std::array<double, 3>& r)
      : a(p[0]),
        edge1(p[1] - p[0]),
        edge2(p[2] - p[0]),
        square1(edge1.length2()),
        square2(edge2.length2()),
        mixed(edge1.dot(edge2)),
        inverse1(inverse(square1)),
        inverse2(inverse(square2)),
        inverse3(inverse(square1 + square2 - 2 * mixed)),
        inverse_area(inverse(square1 * square2 - mixed * mixed)),
        radius(r[0]),
        rise1(r[1] - r[0]),
        rise2(r[2] - r[0]) {}

  static double inverse(double x) { return x > 1e-24 ? 1 / x : 0; }

  /// The nearest point is the foot of the perpendicular if it lies in the triangle, else on the
  /// nearest side. All are compared, so that no lane of a batch branches.
  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> q = p - constant<T>(a);
    const T zero(0.0), one(1.0);
    const T d1 = dot(q, constant<T>(edge1)), d2 = dot(q, constant<T>(edge2));
    const auto at = [&](const T& u, const T& v) {
      // |q - u edge1 - v edge2|^2, less the radius.
      const Point<T> away{q.x - u * T(edge1.x) - v * T(edge2.x),
                          q.y - u * T(edge1.y) - v * T(edge2.y),
                          q.z - u * T(edge1.z) - v * T(edge2.z)};
      return dot(away, away);
    };
    const T t1 = clamp(d1 * T(inverse1), zero, one);
    const T t2 = clamp(d2 * T(inverse2), zero, one);
    const T t3 = clamp((T(square1 - mixed) - d1 + d2) * T(inverse3), zero, one);
    const T on1 = at(t1, zero), on2 = at(zero, t2), on3 = at(one - t3, t3);
    const T u = (d1 * T(square2) - d2 * T(mixed)) * T(inverse_area);
    const T v = (d2 * T(square1) - d1 * T(mixed)) * T(inverse_area);
    T least = on1, share1 = t1, share2 = zero;
    const auto second = on2 < least;
    least = select(second, on2, least);
    share1 = select(second, zero, share1), share2 = select(second, t2, share2);
    const auto third = on3 < least;
    least = select(third, on3, least);
    share1 = select(third, one - t3, share1), share2 = select(third, t3, share2);
    // The least barycentric coordinate; a triangle without an area has no inside.
    const T within = min(min(u, v), one - u - v) - T(inverse_area > 0 ? 0.0 : 1.0);
    const auto flat = within >= zero;
    least = select(flat, at(u, v), least);
    share1 = select(flat, u, share1), share2 = select(flat, v, share2);
    return sqrt(least) - (T(radius) + share1 * T(rise1) + share2 * T(rise2));
  }
  double slope() const {
    // The gradient of the radius within the plane, from the inverse of the metric.
    const double along1 = (rise1 * square2 - rise2 * mixed) * inverse_area,
                 along2 = (rise2 * square1 - rise1 * mixed) * inverse_area;
    return std::sqrt(std::max(0.0, along1 * rise1 + along2 * rise2));
  }
  Box3d box() const {
    Box3d out(a);
    out.extendBy(a + edge1);
    out.extendBy(a + edge2);
    return grown(out, std::max({radius, radius + rise1, radius + rise2}));
  }
};

/// Consecutive facets within a ball that also contains their thickness.
struct Group {
  Vec3d centre{0.0};
  double radius = 0;
  size_t begin = 0, end = 0;

  /// A lower bound of the values of its facets.
  template <class S>
  S bound(const Point<S>& p) const {
    return length(p - constant<S>(centre)) * S(1 - 1e-6) - S(radius * (1 + 1e-6) + 1e-9);
  }
};

constexpr size_t kGroup = 12;

inline const double& value_of(const double& x) { return x; }
inline const Pack& value_of(const Pack& x) { return x; }
template <class S>
const S& value_of(const Dual<S>& x) {
  return x.v;
}
inline bool any(bool condition) { return condition; }

class SheetNode final : public EvaluationModes<SheetNode> {
 public:
  SheetNode(Traits traits, std::string name, std::vector<Facet> facets)
      : EvaluationModes(std::move(traits)), name_(std::move(name)), facets_(std::move(facets)) {
    for (size_t begin = 0; begin < facets_.size(); begin += kGroup) {
      Group group{.begin = begin, .end = std::min(begin + kGroup, facets_.size())};
      Box3d box;
      for (size_t i = begin; i < group.end; ++i) box.extendBy(facets_[i].box());
      group.centre = box.center();
      group.radius = 0.5 * box.size().length();
      groups_.push_back(group);
    }
  }

  /// Groups that cannot contain the least value are not evaluated. Derivatives are computed for the
  /// facets with the least value only.
  template <class T>
  T at(const Point<T>& p) const {
    using S = std::decay_t<decltype(value_of(p.x))>;
    const Point<S> q{value_of(p.x), value_of(p.y), value_of(p.z)};
    S least = facets_[0].distance(q), which(0.0);
    for (const Group& group : groups_) {
      if (!any(group.bound(q) < least)) continue;
      for (size_t i = group.begin; i < group.end; ++i) {
        const S value = facets_[i].distance(q);
        which = select(value < least, S(static_cast<double>(i)), which);
        least = min(least, value);
      }
    }
    if constexpr (std::is_same_v<T, S>) {
      return least;
    } else if constexpr (std::is_same_v<S, double>) {
      return facets_[static_cast<size_t>(which)].distance(p);
    } else {
      float lanes[Pack::kLanes];
      which.store(lanes);
      T out = facets_[static_cast<size_t>(lanes[0])].distance(p);
      for (int k = 1; k < Pack::kLanes; ++k) {
        if (std::find(lanes, lanes + k, lanes[k]) != lanes + k) continue;
        const auto same = abs(which - Pack(lanes[k])) < Pack(0.5);
        out = select(same, facets_[static_cast<size_t>(lanes[k])].distance(p), out);
      }
      return out;
    }
  }
  Interval at(const Point<Interval>& p) const {
    const Ball ball = enclosing_ball(p);
    return centre_form(at(field::point(ball.centre)), ball);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = at(point_for<T>(points[i]));
  }
  /// Keeps the facets that can be nearest within the ball, the nearest to its centre first.
  Restriction restrict_to(const Ball& ball) const override {
    const Point<double> centre = field::point(ball.centre);
    const double least = at(centre);
    const Interval range = centre_form(least, ball);
    if (!(ball.radius < 1e6)) return {range, nullptr};
    const double slack = 1e-6 * (1 + ball.centre.length() + ball.radius);
    const double reach = 2 * traits().lipschitz * (ball.radius + slack);
    std::vector<Facet> kept;
    for (const Group& group : groups_) {
      if (group.bound(centre) > least + reach) continue;
      for (size_t i = group.begin; i < group.end; ++i) {
        const double value = facets_[i].distance(centre);
        if (value > least + reach) continue;
        kept.push_back(facets_[i]);
        if (value <= least) std::swap(kept.front(), kept.back());
      }
    }
    if (kept.empty() || kept.size() == facets_.size()) return {range, nullptr};
    return {range, std::make_shared<SheetNode>(traits(), name_, std::move(kept))};
  }
  std::string name() const override { return name_; }

 private:
  std::string name_;
  std::vector<Facet> facets_;
  std::vector<Group> groups_;
};

Field sheet_of(const std::string& name, std::vector<Facet> facets) {
  Traits traits;
  double slope = 0;
  for (const Facet& facet : facets) {
    traits.bounds.extendBy(facet.box());
    slope = std::max(slope, facet.slope());
  }
  traits.lipschitz = 1 + slope;
  traits.exactness = slope > 0 ? Exactness::sign : Exactness::eikonal;
  traits.growth = 1 / (1 + slope);
  return Field(std::make_shared<SheetNode>(traits, name, std::move(facets)));
}

}  // namespace

Field sheet_field(const std::string& name, const Sheet& sheet) {
  const auto across = static_cast<size_t>(sheet.across);
  std::vector<Facet> facets;
  for (size_t i = 0; i + across < sheet.corners.size(); ++i) {
    if (i % across == across - 1) continue;
    const auto add = [&](size_t a, size_t b, size_t c) {
      const std::array<Vec3d, 3> p{sheet.corners[a], sheet.corners[b], sheet.corners[c]};
      if ((p[1] - p[0]).cross(p[2] - p[0]).length2() > 1e-24)
        facets.emplace_back(p, std::array{sheet.radii[a], sheet.radii[b], sheet.radii[c]});
    };
    add(i, i + 1, i + across);
    add(i + across + 1, i + across, i + 1);
  }
  return facets.empty() ? Field() : sheet_of(name, std::move(facets));
}

}  // namespace vug::field

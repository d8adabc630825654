// SPDX-License-Identifier: Apache-2.0
// Signed distance to a polygon: for a nearest edge the signed distance to the edge's line, for a
// nearest corner the distance with the sign of the crossing number (quilez2008distance). On the
// surface the nearest feature is almost always an edge, so gradients are correct there.
#include <vug/base/maths.h>
#include <vug/facade/outline.h>
#include <vug/field/affine.h>
#include <vug/field/primitive.h>
#include <vug/field/profile.h>

#include <algorithm>

namespace vug::facade {
namespace {

using field::abs;
using field::both;
using field::max;
using field::Point;
using field::select;
using field::sqrt;
using field::square;

struct Polygon {
  struct Edge {
    Vec2d a, along;  ///< A corner and the unit vector to the next one.
    double length, low, high, slope;
  };
  std::vector<Edge> edges;

  explicit Polygon(const Outline& corners, bool revolved) {
    for (size_t i = 0; i < corners.size(); ++i) {
      const Vec2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (revolved && a.x <= 0 && b.x <= 0) continue;  // the axis is not a surface
      const double length = (b - a).length();
      if (length < 1e-9) continue;
      const double rise = b.y - a.y;
      edges.push_back({a, (b - a) / length, length, std::min(a.y, b.y), std::max(a.y, b.y),
                       rise == 0 ? 0 : (b.x - a.x) / rise});
    }
  }

  void add_to(Digester& digester) const { digester(edges); }

  template <class T>
  T distance(const T& x, const T& y) const {
    T least = T(1e30), height = T(0.0), sign = T(1.0);
    T corner = T(0.0);  // 1 if a corner is nearest
    for (const Edge& e : edges) {
      const T dx = x - T(e.a.x), dy = y - T(e.a.y);
      const T along = dx * T(e.along.x) + dy * T(e.along.y);
      const T over = dx * T(e.along.y) - dy * T(e.along.x);
      const T beyond = max(abs(along - T(0.5 * e.length)) - T(0.5 * e.length), T(0.0));
      const T far = square(over) + square(beyond);
      const auto nearer = far < least;
      height = select(nearer, over, height);
      corner = select(nearer, select(beyond > T(0.0), T(1.0), T(0.0)), corner);
      least = select(nearer, far, least);
      const auto level = both(y >= T(e.low), y < T(e.high));
      sign = select(both(level, x < T(e.a.x) + dy * T(e.slope)), -sign, sign);
    }
    return select(corner > T(0.5), sign * sqrt(least), height);
  }
};

struct Extruded {
  Polygon polygon;
  double middle, half;
  Box3d box;

  template <class T>
  T distance(const Point<T>& p) const {
    return field::intersect_orthogonal(polygon.distance(p.x, p.y), abs(p.z - T(middle)) - T(half));
  }
  Box3d bounds() const { return box; }
};

struct Revolved {
  Polygon polygon;
  Box3d box;

  template <class T>
  T distance(const Point<T>& p) const {
    return polygon.distance(field::length(p.x, p.z), p.y);
  }
  Box3d bounds() const { return box; }
};

template <class Shape>
field::Field made(const char* name, Shape shape) {
  return field::Field(
      std::make_shared<field::PrimitiveNode<Shape>>(std::string(name), std::move(shape)));
}

void require(const Outline& outline, bool revolved) {
  double area = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
    if (revolved && a.x < 0)
      throw Error(ErrorCode::internal, "the outline of a solid of revolution crosses its axis");
  }
  if (!(area > 0)) throw Error(ErrorCode::internal, "the outline is not counter-clockwise");
}

}  // namespace

Outline arc(const Vec2d& centre, double radius, double from, double to, int steps) {
  Outline out;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    out.push_back(centre + Vec2d(radius * maths::cos(angle), radius * maths::sin(angle)));
  }
  return out;
}

field::Field extruded(const Outline& outline, double back, double front) {
  require(outline, false);
  Box3d box;
  for (const Vec2d& corner : outline) {
    box.extendBy(Vec3d(corner.x, corner.y, back));
    box.extendBy(Vec3d(corner.x, corner.y, front));
  }
  return made("extruded",
              Extruded{Polygon(outline, false), 0.5 * (back + front), 0.5 * (front - back), box});
}

field::Field moulding(const Outline& outline, double left, double right) {
  return field::transformed(extruded(outline, left, right),
                            Transform({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}));
}

field::Field revolved(const Outline& outline) {
  require(outline, true);
  Box3d box;
  for (const Vec2d& corner : outline) {
    box.extendBy(Vec3d(-corner.x, corner.y, -corner.x));
    box.extendBy(Vec3d(corner.x, corner.y, corner.x));
  }
  return made("turned", Revolved{Polygon(outline, true), box});
}

}  // namespace vug::facade

// SPDX-License-Identifier: Apache-2.0
#include <vug/render/geometry/grid_surface.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

using volume::SurfaceBricks;
using Brick = SurfaceBricks::Brick;
using Position = std::array<double, 3>;
using Index = std::array<int, 3>;
constexpr int kSize = SurfaceBricks::kSize;

/// c[0] + c[1] s + c[2] s^2 + c[3] s^3.
using Cubic = std::array<double, 4>;

double at(const Cubic& c, double s) { return ((c[3] * s + c[2]) * s + c[1]) * s + c[0]; }

/// The values at the corners of a cell, and interpolation at positions within it, 0 to 1 along each
/// axis. Values are integers: at 0 and 1 the interpolation is exact.
struct Cell {
  double v[2][2][2] = {};

  Cell(const Brick& brick, int i, int j, int k) {
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        for (int c = 0; c < 2; ++c) v[a][b][c] = brick.at(i + a, j + b, k + c);
  }
  double value(const Position& p) const {
    double plane[2];
    for (int a = 0; a < 2; ++a) {
      const double low = v[a][0][0] + (v[a][0][1] - v[a][0][0]) * p[2];
      const double high = v[a][1][0] + (v[a][1][1] - v[a][1][0]) * p[2];
      plane[a] = low + (high - low) * p[1];
    }
    return plane[0] + (plane[1] - plane[0]) * p[0];
  }
  Vec3d slope(const Position& p) const {
    Vec3d sum(0.0);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        for (int c = 0; c < 2; ++c) {
          const double x = a ? p[0] : 1 - p[0], y = b ? p[1] : 1 - p[1], z = c ? p[2] : 1 - p[2];
          sum +=
              Vec3d((a ? 1 : -1) * y * z, (b ? 1 : -1) * x * z, (c ? 1 : -1) * x * y) * v[a][b][c];
        }
    return sum;
  }
  /// The cubic along p + s q.
  Cubic along(const Position& p, const Position& q) const {
    double square[2][3];
    for (int a = 0; a < 2; ++a) {
      double line[2][2];
      for (int b = 0; b < 2; ++b) {
        const double step = v[a][b][1] - v[a][b][0];
        line[b][0] = v[a][b][0] + step * p[2], line[b][1] = step * q[2];
      }
      const double d0 = line[1][0] - line[0][0], d1 = line[1][1] - line[0][1];
      square[a][0] = line[0][0] + d0 * p[1];
      square[a][1] = line[0][1] + d0 * q[1] + d1 * p[1];
      square[a][2] = d1 * q[1];
    }
    double d[3];
    for (int i = 0; i < 3; ++i) d[i] = square[1][i] - square[0][i];
    return {square[0][0] + d[0] * p[0], square[0][1] + d[0] * q[0] + d[1] * p[0],
            square[0][2] + d[1] * q[0] + d[2] * p[0], d[2] * q[0]};
  }
};

/// Positions in (0, 1) where the derivative changes its sign, in ascending order; returns their
/// number.
int extrema(const Cubic& c, double (&where)[2]) {
  const double a = 3 * c[3], b = 2 * c[2], d = b * b - 4 * a * c[1];
  if (!(d > 0)) return 0;
  const double q = -0.5 * (b + std::copysign(std::sqrt(d), b));  // without cancellation
  double low = a != 0 ? q / a : 2, high = q != 0 ? c[1] / q : 2;
  if (low > high) std::swap(low, high);
  int count = 0;
  if (low > 0 && low < 1) where[count++] = low;
  if (high > 0 && high < 1) where[count++] = high;
  return count;
}

/// The root between lo, where the sign is `negative`, and hi, where it is not: Newton's method with
/// bisection as a safeguard.
double root_within(const Cubic& c, double lo, double hi, bool negative) {
  double s = 0.5 * (lo + hi);
  for (int step = 0; step < 60; ++step) {
    const double f = at(c, s), slope = (3 * c[3] * s + 2 * c[2]) * s + c[1];
    ((f < 0) == negative ? lo : hi) = s;
    double next = s - f / slope;
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    const double moved = std::fabs(next - s);
    s = next;
    if (moved < 1e-11) break;
  }
  return s;
}

/// The first root in [0, 1]; the signs at both ends are given.
std::optional<double> first_root(const Cubic& c, bool from, bool to) {
  if (from == to) {
    // The convex hull of the Bernstein polynomial rejects most cells.
    const double b1 = c[0] + c[1] * (1 / 3.0), b2 = b1 + (c[1] + c[2]) * (1 / 3.0);
    if ((b1 < 0) == from && (b2 < 0) == from) return std::nullopt;
  }
  double where[2], lo = 0;
  const int count = extrema(c, where);
  for (int i = 0; i < count; ++i) {
    if ((at(c, where[i]) < 0) != from) return root_within(c, lo, where[i], from);
    lo = where[i];
  }
  if (from == to) return std::nullopt;
  return root_within(c, lo, 1, from);
}

/// Positions on a face of cells, up to rounding, are snapped to it, so that the cells on both sides
/// compute the same values.
double on_face(double x) {
  const double whole = std::nearbyint(x);
  return std::fabs(x - whole) < 1e-9 ? whole : x;
}

Position within(const Position& position_at, const Index& cell) {
  Position out;
  for (size_t axis = 0; axis < 3; ++axis)
    out[axis] = std::clamp(position_at[axis] - cell[axis], 0.0, 1.0);
  return out;
}

Position position_of(const Vec3d& p) { return {p.x, p.y, p.z}; }

Index local(const Brick& brick, const Index& cell) {
  return {cell[0] - brick.first[0], cell[1] - brick.first[1], cell[2] - brick.first[2]};
}

}  // namespace

std::optional<Crossing> first_crossing(const SurfaceBricks& surface, size_t number,
                                       const Vec3d& origin, const Vec3d& direction, double begin,
                                       double end) {
  const Brick& brick = surface.bricks()[number];
  const Position o = position_of(surface.to_lattice(origin));
  const Position d = position_of(direction * (1 / surface.voxel()));
  Position inverse{0, 0, 0};
  Index low, high;
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] = brick.first[axis] + brick.low[axis];
    high[axis] = brick.first[axis] + brick.high[axis];
    if (d[axis] == 0) {
      if (o[axis] < low[axis] || o[axis] > high[axis]) return std::nullopt;
      continue;
    }
    inverse[axis] = 1 / d[axis];
    const double a = (low[axis] - o[axis]) * inverse[axis];
    const double b = (high[axis] - o[axis]) * inverse[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (!(begin <= end)) return std::nullopt;

  const auto position_at = [&](double t) {
    return Position{on_face(o[0] + d[0] * t), on_face(o[1] + d[1] * t), on_face(o[2] + d[2] * t)};
  };
  // Cell traversal (Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing",
  // cite amanatides1987traversal); the distances to faces are not accumulated, so that all bricks
  // compute the same.
  Index cell;
  Position next;
  const auto leave = [&](size_t axis) {
    return d[axis] != 0 ? ((cell[axis] + (d[axis] > 0)) - o[axis]) * inverse[axis] : kInfinity;
  };
  for (size_t axis = 0; axis < 3; ++axis) {
    cell[axis] = std::clamp(static_cast<int>(std::floor(o[axis] + d[axis] * begin)), low[axis],
                            high[axis] - 1);
    next[axis] = leave(axis);
  }
  for (double from = begin;;) {
    const size_t axis =
        next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    const double to = std::min(end, next[axis]);
    const Index own = local(brick, cell);
    if (to > from && brick.crossed(own[0], own[1], own[2])) {
      const Cell values(brick, own[0], own[1], own[2]);
      const Position p = within(position_at(from), cell), r = within(position_at(to), cell);
      const Cubic cubic = values.along(p, {r[0] - p[0], r[1] - p[1], r[2] - p[2]});
      const bool inside = cubic[0] < 0;
      if (const auto root = first_root(cubic, inside, values.value(r) < 0))
        return Crossing{from + *root * (to - from), cell, inside};
    }
    from = std::max(from, to);
    cell[axis] += d[axis] > 0 ? 1 : -1;
    if (from >= end || cell[axis] < low[axis] || cell[axis] >= high[axis]) return std::nullopt;
    next[axis] = leave(axis);
  }
}

GridValue trilinear(const SurfaceBricks& surface, size_t number, const Index& cell,
                    const Vec3d& point) {
  const Brick& brick = surface.bricks()[number];
  const Index own = local(brick, cell);
  const Cell values(brick, own[0], own[1], own[2]);
  const Position p = within(position_of(surface.to_lattice(point)), cell);
  return {values.value(p) * surface.step(), values.slope(p) * (surface.step() / surface.voxel())};
}

double trilinear_value(const SurfaceBricks& surface, size_t number, const Vec3d& point) {
  const Brick& brick = surface.bricks()[number];
  Position p = position_of(surface.to_lattice(point));
  Index own;
  for (size_t axis = 0; axis < 3; ++axis) {
    p[axis] -= brick.first[axis];
    own[axis] = std::clamp(static_cast<int>(std::floor(p[axis])), -1, kSize);
    p[axis] -= own[axis];
  }
  return Cell(brick, own[0], own[1], own[2]).value(p) * surface.step();
}

GridValue smooth(const SurfaceBricks& surface, size_t number, const Index& cell,
                 const Vec3d& point) {
  const Brick& brick = surface.bricks()[number];
  const Index own = local(brick, cell);
  const Position p = within(position_of(surface.to_lattice(point)), cell);
  double v[4][4][4];
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      for (int c = 0; c < 4; ++c)
        v[a][b][c] = brick.at(own[0] + a - 1, own[1] + b - 1, own[2] + c - 1);
  double weight[3][4];
  for (size_t axis = 0; axis < 3; ++axis) {
    const double x = p[axis], y = 1 - x;
    weight[axis][0] = -0.5 * x * y * y, weight[axis][1] = y * (1 + x - 1.5 * x * x);
    weight[axis][2] = x * (1 + y - 1.5 * y * y), weight[axis][3] = -0.5 * x * x * y;
  }
  GridValue out;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      double line = 0;
      for (int c = 0; c < 4; ++c) line += weight[2][c] * v[a][b][c];
      out.value += weight[0][a] * weight[1][b] * line;
    }
  for (int a = 1; a < 3; ++a)
    for (int b = 1; b < 3; ++b)
      for (int c = 1; c < 3; ++c) {
        const double x = a > 1 ? p[0] : 1 - p[0], y = b > 1 ? p[1] : 1 - p[1];
        const double z = c > 1 ? p[2] : 1 - p[2];
        out.gradient += Vec3d(v[a + 1][b][c] - v[a - 1][b][c], v[a][b + 1][c] - v[a][b - 1][c],
                              v[a][b][c + 1] - v[a][b][c - 1]) *
                        (x * y * z);
      }
  out.value *= surface.step();
  out.gradient *= 0.5 * surface.step() / surface.voxel();
  return out;
}

}  // namespace vug::render

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/transform.h>

#include <algorithm>
#include <cmath>

namespace vug {

Transform::Transform(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin)
    : column_{x, y, z}, origin_(origin) {
  const double volume = determinant();
  if (!(std::fabs(volume) > 1e-30))
    throw Error(ErrorCode::bad_input, "singular transform: it flattens space and has no inverse");
}

Transform Transform::translation(const Vec3d& by) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by}; }

Transform Transform::rotation(const Vec3d& axis, double angle) {
  // Rodrigues' formula, column by column.
  const Vec3d k = axis.normalized();
  const double c = maths::cos(angle), s = maths::sin(angle);
  auto turned = [&](const Vec3d& v) { return v * c + k.cross(v) * s + k * (k.dot(v) * (1 - c)); };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), Vec3d(0)};
}

Transform Transform::scaling(const Vec3d& f) {
  return {{f.x, 0, 0}, {0, f.y, 0}, {0, 0, f.z}, Vec3d(0)};
}

double Transform::determinant() const { return column_[0].dot(column_[1].cross(column_[2])); }

Vec3d Transform::normal(const Vec3d& n) const {
  const double volume = determinant();
  return (column_[1].cross(column_[2]) * n.x + column_[2].cross(column_[0]) * n.y +
          column_[0].cross(column_[1]) * n.z) /
         volume;
}

Transform Transform::inverse() const {
  const double volume = determinant();
  const Vec3d r0 = column_[1].cross(column_[2]) / volume;
  const Vec3d r1 = column_[2].cross(column_[0]) / volume;
  const Vec3d r2 = column_[0].cross(column_[1]) / volume;
  Transform out;
  out.column_[0] = {r0.x, r1.x, r2.x};
  out.column_[1] = {r0.y, r1.y, r2.y};
  out.column_[2] = {r0.z, r1.z, r2.z};
  out.origin_ = -out.vector(origin_);
  return out;
}

Transform Transform::operator*(const Transform& inner) const {
  return {vector(inner.column_[0]), vector(inner.column_[1]), vector(inner.column_[2]),
          point(inner.origin_)};
}

Box3d Transform::box(const Box3d& b) const {
  if (b.isEmpty()) return b;
  Box3d out(origin_, origin_);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double a = column_[i][j];
      if (a == 0) continue;
      out.min[j] += std::min(a * b.min[i], a * b.max[i]);
      out.max[j] += std::max(a * b.min[i], a * b.max[i]);
    }
  return out;
}

namespace {

/// Largest eigenvalue of the symmetric matrix with columns c^T c, in closed form (Smith 1961).
void gram_eigenvalues(const Vec3d c[3], double& largest, double& smallest) {
  const double a = c[0].dot(c[0]), b = c[1].dot(c[1]), d = c[2].dot(c[2]);
  const double e = c[0].dot(c[1]), f = c[1].dot(c[2]), g = c[0].dot(c[2]);
  const double off = e * e + f * f + g * g;
  if (off == 0) {
    largest = std::max({a, b, d});
    smallest = std::min({a, b, d});
    return;
  }
  const double q = (a + b + d) / 3;
  const double p =
      std::sqrt(((a - q) * (a - q) + (b - q) * (b - q) + (d - q) * (d - q) + 2 * off) / 6);
  const double x = (a - q) / p, y = (b - q) / p, z = (d - q) / p;
  const double u = e / p, v = f / p, w = g / p;
  const double half_det = 0.5 * (x * (y * z - v * v) - u * (u * z - v * w) + w * (u * v - y * w));
  const double phi = maths::acos(half_det) / 3;
  largest = q + 2 * p * maths::cos(phi);
  smallest = q + 2 * p * maths::cos(phi + 2 * kPi / 3);
}

}  // namespace

double Transform::max_stretch() const {
  double largest = 0, smallest = 0;
  gram_eigenvalues(column_, largest, smallest);
  return std::sqrt(std::max(largest, 0.0));
}

double Transform::min_stretch() const {
  double largest = 0, smallest = 0;
  gram_eigenvalues(column_, largest, smallest);
  return std::sqrt(std::max(smallest, 0.0));
}

Transform rotation_between(const Vec3d& from, const Vec3d& to) {
  const Vec3d axis = from.cross(to);
  const double s = axis.length(), c = from.dot(to);
  if (s > 1e-12) return Transform::rotation(axis, maths::atan2(s, c));
  if (c > 0) return {};
  const Vec3d other = std::fabs(from.x) < 0.9 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  return Transform::rotation(from.cross(other), kPi);
}

}  // namespace vug

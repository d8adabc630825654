// SPDX-License-Identifier: Apache-2.0
// Affine maps of world space. Vectors are columns in the docs: q = A p + t.
#pragma once

#include <vug/base/vec.h>

namespace vug {

/// An invertible affine map.
class Transform {
 public:
  Transform() = default;
  /// The linear part is given by its columns (the images of x, y and z); `origin` is the image of
  /// the origin. Throws Error(bad_input) if the linear part is singular.
  Transform(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin);

  static Transform translation(const Vec3d& by);
  /// Right-handed rotation by `angle` radians about `axis` (any length but 0) through the origin.
  static Transform rotation(const Vec3d& axis, double angle);
  static Transform scaling(const Vec3d& factors);

  Vec3d point(const Vec3d& p) const { return origin_ + vector(p); }
  Vec3d vector(const Vec3d& v) const {
    return column_[0] * v.x + column_[1] * v.y + column_[2] * v.z;
  }
  /// Transforms a normal by the inverse transpose; the result is not normalised.
  Vec3d normal(const Vec3d& n) const;
  /// The bounding box of the image of a box (may be infinite).
  Box3d box(const Box3d& b) const;

  Transform inverse() const;
  /// The composition: first `inner`, then this.
  Transform operator*(const Transform& inner) const;

  const Vec3d& column(int i) const { return column_[i]; }
  const Vec3d& origin() const { return origin_; }
  /// The largest and smallest factor by which the map stretches a length (singular values).
  double max_stretch() const;
  double min_stretch() const;
  double determinant() const;

 private:
  Vec3d column_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec3d origin_{0, 0, 0};
};

/// The smallest rotation that maps unit vector `from` to unit vector `to`.
Transform rotation_between(const Vec3d& from, const Vec3d& to);

}  // namespace vug

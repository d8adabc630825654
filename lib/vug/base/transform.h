// Affine maps of world space. Vectors are columns in the docs: q = A p + t.
#pragma once

#include <vug/base/vec.h>

namespace vug {

/// An invertible affine map with its inverse at hand.
class Transform {
 public:
  Transform() = default;
  /// Linear part by its columns (images of x, y, z) and the image of the origin.
  /// Error(bad_input) when the linear part is singular.
  Transform(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin);

  static Transform translation(const Vec3d& by);
  /// Right-handed turn by `angle` radians about `axis` (any length but 0) through the origin.
  static Transform rotation(const Vec3d& axis, double angle);
  static Transform scaling(const Vec3d& factors);

  Vec3d point(const Vec3d& p) const { return origin_ + vector(p); }
  Vec3d vector(const Vec3d& v) const {
    return column_[0] * v.x + column_[1] * v.y + column_[2] * v.z;
  }
  /// Normals go by the inverse transpose; not normalised.
  Vec3d normal(const Vec3d& n) const;
  /// The box around the image of a box (may be infinite).
  Box3d box(const Box3d& b) const;

  Transform inverse() const;
  /// First `inner`, then this.
  Transform operator*(const Transform& inner) const;

  const Vec3d& column(int i) const { return column_[i]; }
  const Vec3d& origin() const { return origin_; }
  /// Largest and smallest factor by which the map stretches a length (singular values).
  double max_stretch() const;
  double min_stretch() const;
  double determinant() const;

 private:
  Vec3d column_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec3d origin_{0, 0, 0};
};

/// A rotation that takes unit vector `from` to unit vector `to` by the shortest way.
Transform rotation_between(const Vec3d& from, const Vec3d& to);

}  // namespace vug

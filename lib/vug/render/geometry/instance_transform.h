// SPDX-License-Identifier: Apache-2.0
// Transforms of mesh instances.
#pragma once

#include <vug/base/transform.h>
#include <vug/render/vectors.h>

#include <memory>
#include <vector>

namespace vug::render {

/// A Transform in single precision, as used for rays.
struct Affine {
  Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  ///< Images of the axes.
  Vec3f origin{0, 0, 0};

  bool operator==(const Affine&) const = default;

  Affine() = default;
  explicit Affine(const Transform& t)
      : x(t.column(0)), y(t.column(1)), z(t.column(2)), origin(t.origin()) {}

  Vec3f vector(const Vec3f& v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3f point(const Vec3f& p) const { return vector(p) + origin; }
  /// Bounding box of the transformed corners of a box.
  Box3f box(const Box3f& from) const {
    Box3f out;
    for (int i = 0; i < 8; ++i)
      out.extendBy(point({i & 1 ? from.max.x : from.min.x, i & 2 ? from.max.y : from.min.y,
                          i & 4 ? from.max.z : from.min.z}));
    return out;
  }
  float determinant() const { return dot(x, cross(y, z)); }
  /// Transforms a normal by the inverse transpose; it keeps pointing outwards. Not of unit length.
  Vec3f normal(const Vec3f& n) const {
    const Vec3f yz = cross(y, z);
    const Vec3f out = yz * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return dot(x, yz) < 0 ? -out : out;
  }
};

/// Transform from a mesh's own space to world space: an affine map, possibly mirroring or
/// non-uniformly scaling, that may change while the shutter is open.
class InstanceTransform {
 public:
  explicit InstanceTransform(const Transform& transform)
      : InstanceTransform(std::vector<Transform>{transform}) {}
  /// Keyframes are evenly spaced from the opening of the shutter to its close; matrices are
  /// interpolated linearly in between. Throws Error(bad_input) without keyframes.
  explicit InstanceTransform(const std::vector<Transform>& keyframes);

  const std::vector<Affine>& keyframes() const { return keyframes_; }
  bool moves() const { return keyframes_.size() > 1; }
  /// `time`: 0 as the shutter opens, 1 as it closes.
  Affine at(float time) const { return moves() ? interpolate(time) : keyframes_[0]; }

  /// The inverse transform, for lookups in the mesh's own space.
  Transform inverse(float time) const;
  /// Mean scale factor over all directions: lengths in world space over lengths in the mesh's
  /// space.
  float mean_scale() const { return mean_scale_; }
  /// Factor of the rounding errors of hits in the mesh's own space, in units in the last place of
  /// the hit's coordinates, relative to those of a mesh in world space.
  float error_scale() const { return error_scale_; }
  /// Largest coordinate of the origins. Added to a hit's coordinates, it bounds the rounding errors
  /// of transformed rays.
  float origin_extent() const { return origin_extent_; }

 private:
  Affine interpolate(float time) const;

  std::vector<Affine> keyframes_;
  Transform inverse_;
  float mean_scale_ = 1, error_scale_ = 1, origin_extent_ = 0;
};
using InstanceTransformPtr = std::shared_ptr<const InstanceTransform>;

/// Whether both are null, or move a mesh to the same places.
inline bool are_equal(const InstanceTransformPtr& a, const InstanceTransformPtr& b) {
  return a == b || (a && b && a->keyframes() == b->keyframes());
}

}  // namespace vug::render

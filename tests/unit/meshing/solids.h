// SPDX-License-Identifier: Apache-2.0
// Solids with known area and volume, and their conversion to meshes.
#pragma once

#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/primitive.h>
#include <vug/field/registry.h>
#include <vug/meshing/polygonize.h>
#include <vug/volume/voxelize.h>

#include <cmath>

namespace vug::meshing {

using field::abs;  // For all number types, including double.
using field::max;

/// Solids for these tests, each with one formula; `half` is half their bounding box.
struct Box {
  Vec3d half;
  template <class T>
  T distance(const field::Point<T>& p) const {
    return max(abs(p.x) - T(half.x), max(abs(p.y) - T(half.y), abs(p.z) - T(half.z)));
  }
  Box3d bounds() const { return {-half, half}; }
  field::Exactness exactness() const { return field::Exactness::bound; }
};

/// About the y axis.
struct Rod {
  double radius, half;
  template <class T>
  T distance(const field::Point<T>& p) const {
    return max(field::length(p.x, p.z) - T(radius), abs(p.y) - T(half));
  }
  Box3d bounds() const { return {-Vec3d(radius, half, radius), Vec3d(radius, half, radius)}; }
  field::Exactness exactness() const { return field::Exactness::bound; }
};

struct Ring {
  double radius, tube;
  template <class T>
  T distance(const field::Point<T>& p) const {
    return field::length(field::length(p.x, p.z) - T(radius), p.y) - T(tube);
  }
  Box3d bounds() const {
    const Vec3d half(radius + tube, tube, radius + tube);
    return {-half, half};
  }
};

struct Capsule {
  double radius, half;
  template <class T>
  T distance(const field::Point<T>& p) const {
    const T over = max(abs(p.y) - T(half), T(0.0));
    return field::length(field::Point<T>{p.x, over, p.z}) - T(radius);
  }
  Box3d bounds() const {
    const Vec3d box(radius, half + radius, radius);
    return {-box, box};
  }
};

/// Tip up.
struct Cone {
  double radius, half;
  template <class T>
  T distance(const field::Point<T>& p) const {
    const double slant = std::sqrt(radius * radius + 4 * half * half);
    const T side =
        field::length(p.x, p.z) * T(2 * half / slant) + (p.y - T(half)) * T(radius / slant);
    return max(side, T(-half) - p.y);
  }
  Box3d bounds() const { return {-Vec3d(radius, half, radius), Vec3d(radius, half, radius)}; }
  field::Exactness exactness() const { return field::Exactness::bound; }
};

template <class P>
field::Field solid(const P& params) {
  return field::Field(std::make_shared<field::PrimitiveNode<P>>("test", params));
}

struct Solid {
  const char* name;
  field::Field field;
  double area;  ///< 0: no closed form.
  double volume;
};

inline field::Field turned(const field::Field& f, const Vec3d& axis, double angle,
                           const Vec3d& by = Vec3d(0)) {
  return field::transformed(f, Transform::translation(by) * Transform::rotation(axis, angle));
}

/// A cube with a corner removed by a rotated cube: edges of all types, none aligned with the
/// lattice, and no thin parts, not even between the cut and the edges of the cube.
struct CutBox {
  static constexpr double kOuterHalf = 1;
  static constexpr double kInnerHalf = 0.6;
  Transform outer = Transform::rotation({1, 2, 3}, 0.7);
  Transform inner =
      Transform::translation(outer.point(Vec3d(1))) * outer * Transform::rotation({2, -1, 1}, 0.35);
  field::Field whole = field::transformed(meshing::solid(Box{Vec3d(kOuterHalf)}), outer);
  field::Field cut = field::transformed(meshing::solid(Box{Vec3d(kInnerHalf)}), inner);
  field::Field solid = field::subtract(whole, {cut});
};

inline field::Field cut_box() { return CutBox().solid; }

/// No edge is sharper than 60 degrees, because the lattice itself loses the tips of those. Not
/// aligned with the lattice, so that no test depends on a fortunate alignment.
inline std::vector<Solid> solids() {
  const Vec3d off(0.0131, -0.0227, 0.0179);
  const auto placed = [&](const field::Field& f) { return turned(f, {1, 0.3, 0.2}, 0.4, off); };
  const field::Field ball = field::make("sphere", {{"radius", 1.0}});
  const field::Field rod = solid(Rod{0.8, 2});
  const double cap = 1 - 0.5 * 1.1;
  const double slant = std::sqrt(0.9 * 0.9 + 2.0 * 2.0);
  return {
      {"sphere", placed(ball), 4 * kPi, 4 * kPi / 3},
      {"torus", placed(solid(Ring{1, 0.4})), 4 * kPi * kPi * 0.4, 2 * kPi * kPi * 0.16},
      {"capsule", placed(solid(Capsule{0.5, 0.6})), kPi * (4 * 0.25 + 2 * 0.5 * 1.2),
       kPi * (4 * 0.125 / 3 + 0.25 * 1.2)},
      {"cone", placed(solid(Cone{0.9, 1})), kPi * 0.9 * (0.9 + slant), kPi * 0.81 * 2.0 / 3},
      {"lens", placed(field::intersect({ball, turned(ball, {1, 0, 0}, 0, {1.1, 0, 0})})),
       4 * kPi * cap, 2 * kPi * cap * cap * (3 - cap) / 3},
      {"steinmetz", placed(field::intersect({rod, turned(rod, {1, 0, 0}, kPi / 2)})), 16 * 0.64,
       16 * 0.512 / 3},
  };
}

inline double volume_of(const mesh::Mesh& mesh) {
  double sum = 0;
  for (size_t f = 0; f < mesh.triangles.size(); ++f)
    sum += mesh::corners(mesh, f)[0].dot(mesh::double_area_vector(mesh, f)) / 6;
  return sum;
}

inline double area(const mesh::Mesh& mesh) {
  double sum = 0;
  for (size_t f = 0; f < mesh.triangles.size(); ++f)
    sum += 0.5 * mesh::double_area_vector(mesh, f).length();
  return sum;
}

inline PolygonizeResult polygonized(const field::Field& f, double voxel,
                                    const PolygonizeOptions& options = {}) {
  volume::VoxelizeOptions voxels;
  voxels.voxel = voxel;
  return polygonize(volume::voxelize(f, voxels), &f, options);
}

}  // namespace vug::meshing

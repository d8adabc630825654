// SPDX-License-Identifier: Apache-2.0
// The surface that carries cells: the triangles of one or several meshes.
#pragma once

#include <vug/mesh/box_tree.h>
#include <vug/mesh/mesh.h>

#include <array>
#include <vector>

namespace vug::cells {

/// A point on the surface.
struct SurfacePoint {
  Vec3f position;
  Vec3f normal;  ///< Unit length; the interpolated normal if the mesh has normals within 60 degrees
                 ///< of the triangle's, otherwise the triangle's normal.
  uint32_t triangle = 0;
};

std::vector<Vec3f> positions(const std::vector<SurfacePoint>& places);

/// Triangles sorted by position, independent of their numbering in the meshes.
class Surface {
 public:
  struct Triangle {
    std::array<Vec3f, 3> corners;  ///< The smallest corner (by x, y, z) first.
    std::array<Vec3f, 3> normals;  ///< At the corners; all 0 if the mesh has none.
    uint32_t object = 0;           ///< Index of the mesh.
  };

  /// Polygons without area are ignored. Throws Error(bad_input) for a mesh that mesh::validate
  /// refuses (indices, lengths, numbers that are not finite), a mesh without area, and a mesh whose
  /// neighbouring triangles disagree about the outside, because cells could not distinguish it from
  /// a thin wall. Holes and open edges are allowed.
  explicit Surface(const std::vector<mesh::MeshPtr>& objects);

  const std::vector<Triangle>& triangles() const { return triangles_; }
  double area() const { return area_; }  ///< Square metres.
  const Box3d& bounds() const { return bounds_; }
  /// The diagonal of the smallest object's bounding box, metres.
  double least_size() const { return least_size_; }

  double area(uint32_t triangle) const;
  Vec3d face_normal(uint32_t triangle) const;
  /// The point with barycentric weights u and v of the second and third corner.
  SurfacePoint at(uint32_t triangle, double u, double v) const;

 private:
  std::vector<Triangle> triangles_;
  double area_ = 0;
  double least_size_ = 0;
  Box3d bounds_;
};

/// Projects cells that left the surface back onto it.
class SurfaceSearch {
 public:
  explicit SurfaceSearch(const Surface& surface);

  /// Projects p, which is `limit` metres from the point `from`: perpendicularly onto its triangle,
  /// otherwise to the nearest point on any triangle with a similar normal. Returns `from` if no
  /// such point lies within the limit.
  SurfacePoint nearest(const Vec3f& p, const SurfacePoint& from, float limit) const;

 private:
  SurfacePoint surface_point(uint32_t triangle, const Vec3d& point) const;

  const Surface* surface_;
  mesh::BoxTree tree_;
};

}  // namespace vug::cells

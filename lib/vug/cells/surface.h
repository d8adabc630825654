// What cells are strewn on: the triangles of one or several meshes as one surface.
#pragma once

#include <vug/mesh/box_tree.h>
#include <vug/mesh/mesh.h>

#include <array>
#include <vector>

namespace vug::cells {

/// A place on a surface.
struct SurfacePoint {
  Vec3f position;
  Vec3f normal;  ///< Unit; the mesh's where it has normals that agree with the triangle, up to 60
                 ///< degrees, else the triangle's.
  uint32_t triangle = 0;
};

std::vector<Vec3f> positions(const std::vector<SurfacePoint>& places);

/// Triangles in an order that depends on where they are, not on how the meshes number them.
class Surface {
 public:
  struct Triangle {
    std::array<Vec3f, 3> corners;  ///< The smallest (by x, y, z) first.
    std::array<Vec3f, 3> normals;  ///< At the corners; all 0 where the mesh has none.
    uint32_t object = 0;           ///< Number of the mesh.
  };

  /// Polygons without area are left out. Error(bad_input) for a mesh that mesh::validate refuses
  /// (indices, lengths, numbers that are not finite), one without any area, and one whose
  /// neighbouring triangles disagree about the outside, which cells could not tell from a thin
  /// wall. Holes and open edges are fine.
  explicit Surface(const std::vector<mesh::MeshPtr>& objects);

  const std::vector<Triangle>& triangles() const { return triangles_; }
  double area() const { return area_; }  ///< Square metres.
  const Box3d& bounds() const { return bounds_; }
  /// The box of the smallest object's diagonal, metres.
  double least_size() const { return least_size_; }

  double area(uint32_t triangle) const;
  Vec3d face_normal(uint32_t triangle) const;
  /// The place with shares u and v of the second and third corner.
  SurfacePoint at(uint32_t triangle, double u, double v) const;

 private:
  std::vector<Triangle> triangles_;
  double area_ = 0;
  double least_size_ = 0;
  Box3d bounds_;
};

/// Finds the way back to a surface for cells that left it.
class SurfaceSearch {
 public:
  explicit SurfaceSearch(const Surface& surface);

  /// The way back from p, which is `limit` metres from the place `from`: straight down to its
  /// triangle, else to the nearest point on any triangle that faces about the same way; `from`
  /// where there is none within the limit.
  SurfacePoint nearest(const Vec3f& p, const SurfacePoint& from, float limit) const;

 private:
  SurfacePoint surface_point(uint32_t triangle, const Vec3d& point) const;

  const Surface* surface_;
  mesh::BoxTree tree_;
};

}  // namespace vug::cells

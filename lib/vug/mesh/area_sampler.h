// SPDX-License-Identifier: Apache-2.0
// Random points on the surface of a mesh, with a uniform density over the area.
#pragma once

#include <vug/base/rng.h>
#include <vug/mesh/mesh.h>

#include <vector>

namespace vug::mesh {

/// A point on a triangle; `u` and `v` are the barycentric weights of its second and third corner.
struct SurfaceSample {
  Vec3d position;
  Vec3d normal;  ///< Unit length, out of the solid; interpolated if the mesh has normals.
  uint32_t triangle = 0;
  double u = 0, v = 0;
  RandomKey key{0};  ///< Random key of this sample, independent of the other samples.
};

/// The mesh must outlive it.
class AreaSampler {
 public:
  /// Only triangles whose normal is within the angle whose cosine is `least_up` of the y axis; -1:
  /// all of them.
  explicit AreaSampler(const Mesh& mesh, double least_up = -1);

  /// The area of these triangles, in square metres.
  double area() const { return cumulative_.empty() ? 0 : cumulative_.back(); }
  /// The point that the numbers of a key select; `area` must be above 0.
  SurfaceSample sample(RandomKey key) const;

 private:
  const Mesh& mesh_;
  std::vector<double> cumulative_;  ///< Areas up to and including each triangle.
};

}  // namespace vug::mesh

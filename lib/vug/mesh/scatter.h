// Points strewn over a mesh, no two too close together.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/rng.h>
#include <vug/mesh/mesh.h>

#include <functional>
#include <vector>

namespace vug::mesh {

/// A place on a triangle: `u` and `v` are the shares of its second and third corner.
struct SurfaceSample {
  Vec3d position;
  Vec3d normal;  ///< Unit, out of the solid; interpolated where the mesh has normals.
  uint32_t triangle = 0;
  double u = 0, v = 0;
  RandomKey key{0};  ///< Its own, whatever becomes of other spots.
};

struct ScatterOptions {
  double spacing = 0.3;         ///< Metres that any two spots are apart at least; above 0.
  size_t max_count = 1u << 20;  ///< Spots at most; these are spread over the whole mesh, too.
  RandomKey key{0};
  /// Share of the spots that stay at a place, 0 to 1; empty: all. Called by several threads.
  std::function<double(const SurfaceSample&)> keep_probability = nullptr;
};

/// Spots by dart throwing, which makes a Poisson-disk set (Cook 1986, "Stochastic sampling in
/// computer graphics", cite cook1986stochastic): candidates spread evenly over the area are taken
/// in turn, unless one that stays is nearer than `spacing` through the air. So many are tried that
/// few others would find room. Of the spots, `share` keeps some by chance, so the density
/// goes with it. The same for any number of threads. Error(too_large) where that takes more than
/// 2^26 candidates.
std::vector<SurfaceSample> scatter(const Mesh& mesh, const ScatterOptions& options,
                                   Progress& progress = Progress::none());

}  // namespace vug::mesh

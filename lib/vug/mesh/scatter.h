// SPDX-License-Identifier: Apache-2.0
// Poisson-disk samples on the surface of a mesh.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/area_sampler.h>

#include <functional>
#include <vector>

namespace vug::mesh {

struct ScatterOptions {
  double spacing = 0.3;         ///< Minimum distance between two samples, metres; above 0.
  size_t max_count = 1u << 20;  ///< Maximum number of samples; these still cover the whole mesh.
  RandomKey key{0};
  /// Probability in 0..1 that a sample at this point is kept; empty: 1. Called from several
  /// threads.
  std::function<double(const SurfaceSample&)> keep_probability = nullptr;
};

/// Dart throwing, which yields a Poisson-disk set (Cook 1986, "Stochastic sampling in computer
/// graphics", cite cook1986stochastic): candidates with a uniform density over the area are
/// accepted in turn unless an accepted one is nearer than `spacing` (straight-line distance). The
/// number of candidates is large enough that few more would fit. Then each sample is kept with
/// `keep_probability`, which modulates the density. The result is the same for any number of
/// threads. Throws Error(too_large) if more than 2^26 candidates are needed.
std::vector<SurfaceSample> scatter(const Mesh& mesh, const ScatterOptions& options,
                                   Progress& progress = Progress::none());

}  // namespace vug::mesh

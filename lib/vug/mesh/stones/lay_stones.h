// SPDX-License-Identifier: Apache-2.0
// Gravel: stones of a distribution of sizes, laid over the ground of a mesh.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/area_sampler.h>
#include <vug/mesh/stones/stone_bed.h>
#include <vug/mesh/stones/stone_sizes.h>

#include <functional>

namespace vug::mesh {

struct LayOptions {
  StoneSizes sizes;
  double cover = 0.25;               ///< Fraction of the ground that stones would cover if none lay
                                     ///< on another; 0 to 1.
  double steepest = 32 * kPi / 180;  ///< Slope of the steepest ground with stones, radians.
  double spread = 0.2;               ///< See sorting.
  double sink = 0.05;                ///< Depth to which a stone sinks in, over its diameter.
  size_t max_count = 100000;         ///< Error(bad_input) if more stones are needed.
  RandomKey key{0};
  /// The index of a shape, for the key of a stone.
  std::function<size_t(RandomKey)> choose_shape;
  /// Fraction of the stones that are kept at a point; empty: 1. Called from several threads.
  std::function<double(const SurfaceSample&)> keep_probability = nullptr;
  /// The coarseness at a point, 0 to 1, for `sorting`; empty: sizes are mixed. Called from several
  /// threads.
  std::function<double(const SurfaceSample&)> coarse = nullptr;
};

struct LaidStone {
  BedStone stone;
  RandomKey key{0};
};

/// The stones, the largest classes first. Each rests on the ground or on other stones by three
/// contacts before it sinks in; those that find no rest are left out. The result is the same for
/// any number of threads.
std::vector<LaidStone> lay_stones(const Mesh& ground, std::vector<StoneShape> shapes,
                                  const LayOptions& options, Progress& progress = Progress::none());

}  // namespace vug::mesh

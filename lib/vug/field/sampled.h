// SPDX-License-Identifier: Apache-2.0
// Fields sampled on a lattice, e.g. the level sets of .vdb files. This module knows only the
// interface; a module that can read such files (volume) supplies the loader.
#pragma once

#include <vug/field/field.h>

#include <functional>

namespace vug::field {

/// Immutable and thread-safe.
class SampledGrid {
 public:
  virtual ~SampledGrid() = default;
  /// Trilinear value in metres and its gradient; plus or minus the background outside the band.
  virtual Gradient sample(const Vec3d& p) const = 0;
  /// World-space box of all samples with a value below the background.
  virtual Box3d bounds() const = 0;
  /// Half-width of the band in which values are distances, metres.
  virtual double band() const = 0;
  /// The maximum slope between samples: sqrt(3) covers any level set, 1 only smooth ones.
  virtual double lipschitz() const = 0;
  /// Identifies the samples and their places.
  virtual Digest digest() const = 0;
};

/// The level set as a field. Beyond the band the value is constant, and outside the bounds it grows
/// with the distance to them, so it is a lower bound of the distance.
Field sampled(std::shared_ptr<const SampledGrid> grid);

/// Reads the level set `name` of a file; an empty name selects the first. Throws Error(bad_input).
using GridLoader = std::function<std::shared_ptr<const SampledGrid>(const std::string& file,
                                                                    const std::string& name)>;

/// Sets the loader of the kind `grid`, replacing an earlier one. Must not be called while scenes
/// are read.
void set_grid_loader(GridLoader loader);
/// Throws Error(bad_input) if no loader was set.
std::shared_ptr<const SampledGrid> load_grid(const std::string& file, const std::string& name);

}  // namespace vug::field

// Fields kept as samples on a lattice, e.g. the level sets of .vdb files. This module knows only
// the interface: whoever can read such files (the volume module) gives the loader.
#pragma once

#include <vug/field/field.h>

#include <functional>

namespace vug::field {

/// Immutable and thread-safe.
class SampledGrid {
 public:
  virtual ~SampledGrid() = default;
  /// Trilinear value, metres, and its gradient; outside the band plus or minus the background.
  virtual Gradient sample(const Vec3d& p) const = 0;
  /// World box of all samples with a value below the background.
  virtual Box3d bounds() const = 0;
  /// Half-width of the band in which values are distances, metres.
  virtual double band() const = 0;
  /// The largest slope between samples: sqrt(3) covers any level set, 1 only smooth ones.
  virtual double lipschitz() const = 0;
};

/// The level set as a field. Beyond the band the value stays at the band's, and outside of the
/// bounds it grows with the distance to them, so it is a lower bound of the distance.
Field sampled(std::shared_ptr<const SampledGrid> grid);

/// Reads the level set `name` of a file; an empty name takes the first. Error(bad_input).
using GridLoader = std::function<std::shared_ptr<const SampledGrid>(const std::string& file,
                                                                    const std::string& name)>;

/// Gives the kind `grid` its loader, instead of an earlier one; not while scenes are read.
void set_grid_loader(GridLoader loader);
/// Error(bad_input) when no loader was given.
std::shared_ptr<const SampledGrid> load_grid(const std::string& file, const std::string& name);

}  // namespace vug::field

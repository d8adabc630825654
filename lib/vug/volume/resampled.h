// Grids on the voxels of another: what else is known of where something is.
#pragma once

#include <vug/volume/grid.h>

#include <functional>

namespace vug::volume {

/// A fog grid of floats with the active voxels of `where`, each with what `value` says of its
/// middle (metres); 0 elsewhere. `value` is called from several threads. What is the same in a
/// whole block takes no room.
Grid resampled(const Grid& where, const std::function<float(const Vec3f&)>& value);
/// The same of vectors (vec3s).
Grid resampled_vectors(const Grid& where, const std::function<Vec3f(const Vec3f&)>& value);

}  // namespace vug::volume

// SPDX-License-Identifier: Apache-2.0
// Functions resampled onto the voxels of another grid.
#pragma once

#include <vug/volume/grid.h>

#include <functional>

namespace vug::volume {

/// A float fog grid with the active voxels of `where`, each with `value` at the voxel centre
/// (metres); 0 elsewhere. `value` is called from several threads. Constant blocks are stored as
/// tiles.
Grid resampled(const Grid& where, const std::function<float(const Vec3f&)>& value);
/// `resampled` for vectors (vec3s).
Grid resampled_vectors(const Grid& where, const std::function<Vec3f(const Vec3f&)>& value);

}  // namespace vug::volume

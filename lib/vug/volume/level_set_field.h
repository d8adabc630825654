// SPDX-License-Identifier: Apache-2.0
// Level sets as sampled fields, for the field kind `grid`.
#pragma once

#include <vug/field/sampled.h>
#include <vug/volume/level_set.h>

namespace vug::volume {

/// Trilinear samples of a level set; the gradient is that of the interpolant.
std::shared_ptr<const field::SampledGrid> sampled_grid(const LevelSet& level_set);

/// Enables the field kind `grid` to read .vdb files. Call before scenes are read; repeated
/// calls and calls from any thread are allowed.
void install_grid_loader();

}  // namespace vug::volume

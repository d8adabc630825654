// Level sets as fields: the samples behind the field kind `grid`.
#pragma once

#include <vug/field/sampled.h>
#include <vug/volume/level_set.h>

namespace vug::volume {

/// Trilinear samples of a level set; its gradient is that of the interpolant.
std::shared_ptr<const field::SampledGrid> sampled_grid(const LevelSet& level_set);

/// Lets the field kind `grid` read .vdb files; to be called before scenes are read, as often as one
/// likes and by any thread.
void install_grid_loader();

}  // namespace vug::volume

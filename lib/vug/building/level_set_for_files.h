// SPDX-License-Identifier: Apache-2.0
// Level sets with the distances that a plan requests for its files.
#pragma once

#include <vug/building/builder.h>

namespace vug::building {

/// The level set of the plan, with the values that it requests or else with those of `automatic`.
/// The metadata `vug:distance` states them if the plan requests them or they are exact. Meshes and
/// masks use Builder::level_set, so that they do not depend on this choice. Error(too_large).
volume::LevelSet level_set_for_files(Builder& builder, const shot::VolumePtr& plan,
                                     shot::DistanceValues automatic);

}  // namespace vug::building

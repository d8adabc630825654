// SPDX-License-Identifier: Apache-2.0
// Features of a level set's mesh that are smaller than two voxels: closed bubbles and crumbs, and
// handles. Sampling makes them where sheets of the surface meet at a sharp angle, for example in
// the crotch of two tubes, and the field has none there.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/volume/level_set.h>

#include <string>
#include <vector>

namespace vug::volume {

struct SmallFeature {
  enum class Kind {
    bubble,  ///< Air that solid encloses, at most two samples wide along each axis.
    crumb,   ///< The same of solid in air.
    handle,  ///< A tunnel or bridge with a cross-section of one or two samples, along a gap as
             ///< small.
  };
  Kind kind = Kind::bubble;
  Vec3d at;                    ///< Its centre in world space, metres.
  std::vector<Vec3i> samples;  ///< Lattice points that change sides to remove it.
};

/// "bubble", "crumb" or "handle".
std::string to_string(SmallFeature::Kind kind);
/// "2 bubbles, 1 handle, at (1, 2.5, 3), (4, 5, 6) and 1 other place".
std::string describe(const std::vector<SmallFeature>& features);

/// The small features of the mesh that polygons_of makes of the level set, each as if those before
/// it had been removed; bubbles and crumbs precede handles. Handles are at most six voxels long,
/// unless `exact`, the field that the level set samples, shows that the gap does not exist. The
/// same for any number of threads. Checks `progress` for cancellation, but begins no stage.
std::vector<SmallFeature> find_small_features(const LevelSet& level_set,
                                              const field::Field* exact = nullptr,
                                              const Progress& progress = Progress::none());

/// The level set with these features removed: their samples change signs and keep their magnitudes,
/// all other samples keep their bits.
LevelSet without_features(const LevelSet& level_set, const std::vector<SmallFeature>& features);

}  // namespace vug::volume

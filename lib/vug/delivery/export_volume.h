// Volumes as other programs look for them.
#pragma once

#include <vug/building/builder.h>
#include <vug/exchange/medium.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::delivery {

/// The grids of one file.
struct ExportVolume {
  std::string name;                      ///< Of the volume or the medium.
  std::vector<volume::Grid> grids;       ///< In metres, y up.
  std::optional<exchange::Medium> medium;  ///< What they mean, where a medium says it.
};

/// A level set as `surface` (`air` of one that the scene calls air), a fog as `density`; of the fog
/// that a cloud of the scene stands on, `color`, `temperature` and `flame` as well, where these
/// vary. Error(too_large).
ExportVolume export_volume(building::Builder& builder, const shot::VolumePtr& plan);

/// Whether the scene's medium has grids of its own, of a file.
bool has_own_grids(const shot::Shot& shot);
/// That medium: `density` and the others. Error(bad_input) where its file cannot be read.
ExportVolume export_medium(building::Builder& builder);

}  // namespace vug::delivery

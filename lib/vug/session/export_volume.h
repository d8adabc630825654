// Volumes as other programs look for them.
#pragma once

#include <vug/exchange/cloud.h>
#include <vug/session/build.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::session {

/// The grids of one file.
struct ExportVolume {
  std::string name;                      ///< Of the volume or the medium.
  std::vector<volume::Grid> grids;       ///< In metres, y up.
  std::optional<exchange::Cloud> cloud;  ///< What they mean, where a medium says it.
};

/// A level set as `surface` (`air` of one that the scene calls air), a fog as `density`; of the fog
/// that a cloud of the scene stands on, `color`, `temperature` and `flame` as well, where these
/// vary. Error(too_large).
ExportVolume export_volume(Builder& builder, const VolumePtr& plan);

/// Whether the scene's medium has grids of its own, of a file.
bool has_own_grids(const Shot& shot);
/// That medium: `density` and the others. Error(bad_input) where its file cannot be read.
ExportVolume export_medium(Builder& builder);

}  // namespace vug::session

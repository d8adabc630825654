// SPDX-License-Identifier: Apache-2.0
// Selects and converts the grids of a volume for other programs; volume/converted.h changes their
// coordinates.
#pragma once

#include <vug/building/builder.h>
#include <vug/exchange/medium.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::delivery {

/// The grids of one file.
struct ExportVolume {
  std::string name;                        ///< Name of the volume or the medium.
  std::vector<volume::Grid> grids;         ///< In metres, y up.
  std::optional<exchange::Medium> medium;  ///< Interpretation of the grids, if there is a medium.
};

/// A level set, with exact distances unless its plan requests bounds, as `surface` (as `air` if the
/// scene calls it air), with the grids of its rock materials; a fog as `density`. The fog of a
/// cloud also gets `color`, `temperature` and `flame` if these vary. Error(too_large).
ExportVolume export_volume(building::Builder& builder, const shot::VolumePtr& plan);

/// Whether the medium has its own grids, from a file.
bool has_own_grids(const shot::MediumPlan& plan);
/// The grids of that medium: `density` and the others. Error(bad_input) if its file cannot be read.
ExportVolume export_medium(const shot::MediumPlan& plan);

}  // namespace vug::delivery

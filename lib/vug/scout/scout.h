// SPDX-License-Identifier: Apache-2.0
// Finds shots of a scene: poses whose views pass the gates, with the best and most different
// compositions.
#pragma once

#include <vug/base/progress.h>
#include <vug/scout/choose.h>
#include <vug/scout/illumination.h>
#include <vug/scout/lamps.h>
#include <vug/scout/location.h>

#include <optional>
#include <string>

namespace vug::scout {

struct ScoutOptions {
  size_t shots = 12;
  uint64_t seed = 0;
  /// Score the light of the scene's own lamps, too: dark views are not chosen.
  bool judge_light = true;
  double key_ratio = kKeyRatio;  ///< See choose_lamps.
  /// Where kit/lamps.vug is searched, for a location that is not lit.
  std::vector<std::filesystem::path> data_folders;
};

struct ScoutedShot {
  Candidate candidate;  ///< Its numbers are those that shot_text writes.
  ScoreTerms terms;
  double score = 0;
  std::vector<Lamp> lamps;  ///< Those of the shot; empty if the location is lit.
};

struct ScoutResult {
  std::vector<ScoutedShot> shots;  ///< Best first.
  size_t candidates = 0;           ///< The number of views that were scored.
  size_t passed = 0;               ///< The number of them that passed all gates.
  /// The gate that refused most of them, if fewer than `shots` passed; then views that fail one
  /// gate that is not strict may be chosen.
  std::optional<Gate> strictest;
};

/// Searches the whole floor. Shots of a location that is not lit get lamps. The same shots for any
/// number of threads. Error(bad_input) if the scene has no floor, or no view that fails at most one
/// gate; Error(cancelled).
ScoutResult find_shots(const Location& location, const ScoutOptions& options,
                       Progress& progress = Progress::none());

}  // namespace vug::scout

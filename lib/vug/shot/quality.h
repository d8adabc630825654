// SPDX-License-Identifier: Apache-2.0
// The quality of a picture: numbers of samples, a limit for the noise, and denoising.
#pragma once

#include <vug/base/kind.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::shot {

struct RenderSettings;

enum class Quality {
  unstated,  ///< As `spp`, `noise` and `denoise` say.
  draft,     ///< Few samples, denoised: for composition and light.
  look,      ///< A picture that can be judged.
  final,     ///< Converged, and not denoised.
};

/// The names of the qualities other than `unstated`, for tables and options.
const std::vector<std::pair<std::string, Quality>>& quality_names();

/// The settings that a quality stands for.
struct QualityTargets {
  int spp = 0;       ///< Most samples per pixel.
  double noise = 0;  ///< See render::Options.
  bool denoise = false;
};
QualityTargets quality_targets(Quality quality);

/// Sets `spp`, `noise` and `denoise` from the quality, unless they have values of their own.
/// `stated` are the names of the settings in the scene, `overrides` those that replace them.
///   - A quality replaces the values of the scene if it is an override, and only fills those that
///     the scene omits if the scene has it.
///   - A picture with `spp` has exactly that number of samples, unless it has `noise`, too.
///   - A picture without quality, `spp` and `noise` gets the quality `look`.
void apply_quality(RenderSettings& settings, const std::vector<std::string>& stated,
                   const NamedValues& overrides);

}  // namespace vug::shot

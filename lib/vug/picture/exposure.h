// SPDX-License-Identifier: Apache-2.0
// The exposure of a finished picture in stops.
#pragma once

#include <vug/image/image.h>
#include <vug/shot/render_settings.h>

#include <filesystem>
#include <map>
#include <string>

namespace vug::picture {

/// Name of the exposure in the metadata of an EXR.
inline constexpr const char* kExposure = "vug:exposure";

/// The stops of the settings. For the exposures auto and locked, image::metered_exposure meters the
/// picture; 0 if it has no light. All exposures but numbers are rounded to hundredths, so that they
/// can be copied into a scene.
double exposure_stops(const shot::OutputSettings& settings, const image::Image& picture);

/// The exposures of a sequence, for the mode locked: by the name of the render block.
class ExposureLock {
 public:
  /// Replaces the exposure `locked` by the stops of the first picture of `render`, which is this
  /// one if none was seen before. Other settings remain as they are.
  void apply(const std::string& render, const image::Image& picture,
             shot::OutputSettings& settings);
  /// Takes the exposure from a finished picture of an earlier run, if it is the first one.
  void take(const std::string& render, const std::filesystem::path& exr);

 private:
  std::map<std::string, double> stops_;
};

}  // namespace vug::picture

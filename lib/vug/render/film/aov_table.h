// SPDX-License-Identifier: Apache-2.0
// The table of all AOVs.
#pragma once

#include <vug/render/film/film.h>

#include <string>
#include <vector>

namespace vug::render {

/// Name of the AOV of MotionStep::motion, in pixels.
inline constexpr const char* kMotion = "motion";

/// Where the values of an AOV come from.
enum class AovSource {
  pixel_sum,        ///< AovInfo::write.
  light_component,  ///< One of LightComponent.
  motion,           ///< MotionStep.
  surface,          ///< SurfaceAov.
  light_group,      ///< The lights of a group; one AOV for each group.
  attribute,        ///< A mesh attribute; one AOV for each attribute.
  cryptomatte
};

/// Writes the channels of a pixel in order.
struct ChannelWriter {
  const PixelSum& sum;
  float* to;

  void put(double v) { *to++ = static_cast<float>(v); }
};

/// A row of the table. Light groups and attributes have one row for all their AOVs, with NAME in
/// place of the name.
struct AovInfo {
  std::string name;
  std::string doc;
  std::vector<std::string> channels;
  AovSource source = AovSource::pixel_sum;
  bool is_default = false;                  ///< Written if no AOVs are requested.
  std::string set = {};                     ///< A name that requests a set of AOVs; may be empty.
  void (*write)(ChannelWriter&) = nullptr;  ///< Only for AovSource::pixel_sum.
};

/// The rows, in the order of the channels in pictures.
const std::vector<AovInfo>& aovs();

/// The row of an AOV: that of its name, or of its prefix, such as "light_"; null for other names.
const AovInfo* find_aov(const std::string& name);
/// The channels of an AOV, whose name is known.
std::vector<std::string> aov_channels(const std::string& name);
/// For rows of light groups and attributes: "light_key" for "key", and back.
std::string aov_name(const AovInfo& row, const std::string& name);
std::string name_in_aov(const std::string& aov);
bool is_from(const std::string& aov, AovSource source);

}  // namespace vug::render

// SPDX-License-Identifier: Apache-2.0
#include <vug/image/brightness.h>
#include <vug/image/io.h>
#include <vug/picture/exposure.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vug::picture {
namespace {

double unrounded_stops(const shot::OutputSettings& settings, const image::Image& picture) {
  if (settings.exposure.metered())
    return image::metered_exposure(picture, settings.working_space).value_or(0);
  return shot::physical_stops({settings.iso, settings.f_number, settings.exposure_time});
}

}  // namespace

double exposure_stops(const shot::OutputSettings& settings, const image::Image& picture) {
  using Mode = shot::Exposure::Mode;
  if (settings.exposure.mode == Mode::stops) return settings.exposure.stops;
  const double stops = unrounded_stops(settings, picture) + settings.compensation;
  return std::clamp(std::round(stops * 100) / 100, -30.0, 30.0);
}

void ExposureLock::apply(const std::string& render, const image::Image& picture,
                         shot::OutputSettings& settings) {
  if (settings.exposure.mode != shot::Exposure::Mode::locked) return;
  const auto found = stops_.try_emplace(render, 0.0);
  if (found.second) found.first->second = exposure_stops(settings, picture);
  settings.exposure = {shot::Exposure::Mode::stops, found.first->second};
}

void ExposureLock::take(const std::string& render, const std::filesystem::path& exr) {
  if (stops_.count(render)) return;
  for (const auto& [name, text] : image::read_info(exr).metadata)
    if (name == kExposure) stops_.emplace(render, std::strtod(text.c_str(), nullptr));
}

}  // namespace vug::picture

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/srgb.h>
#include <vug/image/layers.h>
#include <vug/render/film/aov_table.h>
#include <vug/viewport/shown_layer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::viewport {
namespace {

using render::AovSource;

bool is_light_layer(const std::string& name) {
  return name == image::kBeauty || render::is_from(name, AovSource::light_component) ||
         render::is_from(name, AovSource::light_group);
}

struct ValueRange {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  /// 0 at the smallest value, 1 at the largest.
  float share(float value) const {
    if (!std::isfinite(value)) return value > 0 ? 1 : 0;
    return high > low ? (value - low) / (high - low) : 0;
  }
};

/// Values that are not finite do not count: a ray that leaves the scene has an infinite depth.
ValueRange range_of(const std::vector<float>& values) {
  ValueRange out;
  for (const float each : values)
    if (std::isfinite(each)) out.low = std::min(out.low, each), out.high = std::max(out.high, each);
  return out;
}

}  // namespace

std::optional<ShownLayer> shown_layer(const image::Image& picture, const std::string& name) {
  const std::vector<image::Layer> layers = image::layers_of(picture.channels);
  const auto found = std::find_if(layers.begin(), layers.end(),
                                  [&](const image::Layer& each) { return each.name == name; });
  if (found == layers.end()) return std::nullopt;
  const image::Image values = image::extract(picture, *found);
  if (is_light_layer(name) && found->colour()) return ShownLayer{values, true};
  if (name == "albedo") return ShownLayer{values, false};
  const ValueRange range = name == "N" ? ValueRange{-1, 1} : range_of(values.pixels);
  ShownLayer out{image::Image(values.width, values.height, {"R", "G", "B"}), false};
  const size_t count = values.channels.size();
  for (size_t p = 0; p < values.pixel_count(); ++p)
    for (size_t c = 0; c < 3; ++c)
      out.image.pixels[3 * p + c] = static_cast<float>(srgb_decode(
          static_cast<double>(range.share(values.pixels[p * count + std::min(c, count - 1)]))));
  return out;
}

std::vector<std::string> layers_to_show(const image::Image& picture) {
  std::vector<std::string> out;
  for (const image::Layer& each : image::layers_of(picture.channels))
    if (each.name.rfind("Crypto", 0) != 0) out.push_back(each.name);
  return out;
}

}  // namespace vug::viewport

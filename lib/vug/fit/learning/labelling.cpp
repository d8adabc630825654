// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/fit/learning/labelling.h>

#include <algorithm>

namespace vug::fit {

std::vector<uint8_t> most_likely_classes(const Planes& maps) {
  std::vector<uint8_t> out(maps.pixels(), 0);
  for (size_t c = 1; c < maps.count(); ++c)
    for (size_t i = 0; i < out.size(); ++i)
      if (maps.planes[c][i] > maps.planes[out[i]][i]) out[i] = static_cast<uint8_t>(c);
  return out;
}

std::vector<uint8_t> region_map(const std::vector<DetectedElement>& seen, int width, int height) {
  std::vector<uint8_t> out(static_cast<size_t>(width) * static_cast<size_t>(height),
                           static_cast<uint8_t>(RegionType::wall));
  for (const DetectedElement& one : seen)
    for (int y = std::max(0, one.rect.y0); y < std::min(height, one.rect.y1); ++y)
      for (int x = std::max(0, one.rect.x0); x < std::min(width, one.rect.x1); ++x)
        out[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
            static_cast<uint8_t>(one.type);
  return out;
}

std::vector<uint8_t> label_pixels(const Planes& maps, const Classes& classes,
                                  const std::vector<DetectedElement>& seen,
                                  const LabellingOptions& options) {
  if (maps.count() != classes.names.size())
    throw Error(ErrorCode::bad_input, "the number of maps must match the number of classes");
  const std::vector<uint8_t> types = region_map(seen, maps.width, maps.height);
  const auto tree_bias = static_cast<float>(maths::pow(2, options.tree_bias));
  Planes weighed = maps;
  for (size_t c = 0; c < maps.count(); ++c) {
    const RegionType type = classes.region_type(static_cast<int>(c));
    for (size_t i = 0; i < types.size(); ++i) {
      if (static_cast<RegionType>(types[i]) == type && type != RegionType::wall)
        weighed.planes[c][i] *= tree_bias;
      else if (static_cast<RegionType>(types[i]) != type && type != RegionType::wall)
        weighed.planes[c][i] /= tree_bias;
    }
  }
  return most_likely_classes(weighed);
}

}  // namespace vug::fit

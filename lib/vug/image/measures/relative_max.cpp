// SPDX-License-Identifier: Apache-2.0
// A difference is relative to the larger of the two values, or to the mean of the layer if both are
// smaller: rounding losses in dark regions do not count.
#include <vug/image/measure_kind.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

MeasureResult relative_max(const Comparison& pair) {
  const double mean = differences(pair).magnitude;
  const size_t channels = pair.reference.channels.size();
  MeasureResult out;
  out.map.assign(pair.pixel_count(), 0.0f);
  for (size_t i = 0; i < pair.reference.pixels.size(); ++i) {
    const auto a = static_cast<double>(pair.reference.pixels[i]);
    const auto b = static_cast<double>(pair.test.pixels[i]);
    if (a == b || (std::isnan(a) && std::isnan(b))) continue;
    const bool finite = std::isfinite(a) && std::isfinite(b);
    const double size = std::max({std::fabs(a), std::fabs(b), mean});
    const double difference = finite ? std::fabs(a - b) / size : kInfinity;
    float& of_pixel = out.map[i / channels];
    of_pixel = std::max(of_pixel, static_cast<float>(difference));
    if (pair.counts(i / channels)) out.value = std::max(out.value, difference);
  }
  return out;
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(relative_max) {
  return lower_is_better(
      "relative_max",
      "Largest difference of two values relative to the larger one or the layer's mean.", "",
      relative_max);
}

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/require_kind.h>
#include <vug/image/measure.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vug::image {

const Measure& measure_of(const std::string& name) {
  return require_kind(measures(), name, fmt::format("unknown measure '{}'", name));
}

void require_comparable(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw Error(ErrorCode::bad_input,
                fmt::format("images of different size cannot be compared: {} x {} and {} x {}",
                            reference.width, reference.height, test.width, test.height));
  if (reference.channels != test.channels)
    throw Error(ErrorCode::bad_input,
                fmt::format("images with different channels cannot be compared: {} and {}",
                            fmt::join(reference.channels, " "), fmt::join(test.channels, " ")));
}

double measure(const std::string& name, const Image& reference, const Image& test) {
  require_comparable(reference, test);
  Comparison pair;
  pair.reference = reference;
  pair.test = test;
  return measure_of(name).measure(pair).value;
}

double pooled_mean(const Comparison& pair, const std::vector<float>& map) {
  double sum = 0;
  size_t count = 0;
  for (size_t p = 0; p < map.size(); ++p) {
    if (!pair.counts(p)) continue;
    sum += static_cast<double>(map[p]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

Differences differences(const Comparison& pair) {
  const size_t channels = pair.reference.channels.size();
  Differences out;
  out.largest_of_pixel.assign(pair.pixel_count(), 0.0f);
  size_t count = 0;
  for (size_t i = 0; i < pair.reference.pixels.size(); ++i) {
    const auto a = static_cast<double>(pair.reference.pixels[i]);
    const auto b = static_cast<double>(pair.test.pixels[i]);
    const bool finite = std::isfinite(a) && std::isfinite(b);
    const bool same = a == b || (std::isnan(a) && std::isnan(b));
    const double difference = same ? 0 : finite ? std::fabs(a - b) : kInfinity;
    float& of_pixel = out.largest_of_pixel[i / channels];
    of_pixel = std::max(of_pixel, static_cast<float>(difference));
    if (!pair.counts(i / channels)) continue;
    ++count;
    if (!finite) ++out.not_finite;
    out.squares += difference * difference;
    out.mean += difference;
    out.largest = std::max(out.largest, difference);
    if (finite) out.magnitude += 0.5 * (std::fabs(a) + std::fabs(b));
  }
  const double n = count > 0 ? static_cast<double>(count) : 1;
  out.squares /= n;
  out.mean /= n;
  out.magnitude /= n;
  return out;
}

}  // namespace vug::image

// SPDX-License-Identifier: Apache-2.0
// The FLIP measure of HDR pictures: the largest difference over a range of exposures.
#include <vug/base/log2.h>
#include <vug/base/parallel.h>
#include <vug/image/flip.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

constexpr double kShoulder = 0.85;  ///< Value of the aces_curve at the ends of the range.

// Narkowicz's fit of the ACES aces_curve (narkowicz2016aces) with its exposure of 0.6 included: (a
// x^2 + b x) / (c x^2 + d x + e).
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03;
constexpr double kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59, kE = 0.14;

double aces_curve(double x) {
  // The aces_curve is flat for large values; a cap keeps squares finite.
  x = std::isnan(x) ? 0 : std::clamp(x, 0.0, 1e9);
  return std::clamp((x * (kA * x + kB)) / (x * (kC * x + kD) + kE), 0.0, 1.0);
}

/// The light that the aces_curve maps to y: the larger root of a quadratic.
double light_of(double y) {
  const double p = (kB - kD * y) / (kA - kC * y), q = -kE * y / (kA - kC * y);
  return -p / 2 + std::sqrt(p * p / 4 - q);
}

std::vector<double> luminances(const Image& picture) {
  constexpr double kWeights[] = {0.2126, 0.7152, 0.0722};
  const char* names[] = {"R", "G", "B"};
  std::vector<double> out(picture.pixel_count(), 0.0);
  for (size_t i = 0; i < 3; ++i) {
    const auto c = static_cast<size_t>(picture.find_channel(names[i]));
    for (size_t p = 0; p < out.size(); ++p) {
      const auto v = static_cast<double>(picture.pixels[p * picture.channels.size() + c]);
      if (std::isfinite(v)) out[p] += kWeights[i] * std::max(v, 0.0);
    }
  }
  return out;
}

/// The median of sorted values: the mean of the middle two for an even count.
double median(const std::vector<double>& ordered) {
  const size_t n = ordered.size();
  return 0.5 * (ordered[(n - 1) / 2] + ordered[n / 2]);
}

Image exposed(const Image& picture, double stops) {
  const double gain = maths::exp2(stops);
  Image out = picture.select({"R", "G", "B"});
  parallel_for(
      out.pixels.size(),
      [&](size_t i) {
        out.pixels[i] = static_cast<float>(aces_curve(gain * static_cast<double>(out.pixels[i])));
      },
      4096);
  return out;
}

}  // namespace

int ExposureRange::count() const { return std::max(2, static_cast<int>(std::ceil(stop - start))); }

std::optional<ExposureRange> exposure_range(const Image& reference) {
  std::vector<double> light = luminances(reference);
  std::sort(light.begin(), light.end());
  if (!(light.back() > 0)) return {};
  double middle = median(light);
  if (!(middle > 0))
    middle = median({std::upper_bound(light.begin(), light.end(), 0.0), light.end()});
  const double at = light_of(kShoulder);
  return ExposureRange{maths::log2(at / light.back()), maths::log2(at / middle)};
}

Plane flip_hdr(const Image& reference, const Image& test, const ExposureRange& range,
               const FlipOptions& options) {
  const int count = range.count();
  Plane out;
  for (int i = 0; i < count; ++i) {
    const double stops = range.start + (range.stop - range.start) * i / (count - 1);
    const Plane at = flip(exposed(reference, stops), exposed(test, stops), options);
    if (i == 0) out = at;
    for (size_t p = 0; p < out.values.size(); ++p)
      out.values[p] = std::max(out.values[p], at.values[p]);
  }
  return out;
}

}  // namespace vug::image

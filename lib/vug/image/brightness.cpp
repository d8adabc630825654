// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/image/brightness.h>
#include <vug/image/colour_channels.h>

#include <vector>

namespace vug::image {
namespace {

constexpr double kNaturalLog2 = 0.69314718055994530942;

double stops_of(double factor) { return maths::log(factor) / kNaturalLog2; }

/// The luminance of each pixel; empty without R, G and B.
std::vector<double> luminance_of_pixels(const Image& linear, WorkingSpace space) {
  constexpr double kWeights[] = {0.2126, 0.7152, 0.0722};  // luminance weights of Rec.709
  std::vector<double> out;
  const std::optional<Channels> channels = colour_channels(linear);
  if (!channels) return out;
  const ColourMatrix to_rec709(space, WorkingSpace::rec709);
  out.reserve(linear.pixel_count());
  for (size_t p = 0; p < linear.pixel_count(); ++p) {
    const Vec3d c = to_rec709(colour_at(linear, p, *channels));
    double luminance = 0;
    for (int i = 0; i < 3; ++i) luminance += kWeights[i] * displayable(c[i]);
    out.push_back(luminance);
  }
  return out;
}

/// The value below which the fraction `share` of the sorted values lies.
double percentile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

double fraction_above(const Image& linear, double luminance, WorkingSpace space) {
  const std::vector<double> all = luminance_of_pixels(linear, space);
  const auto above = std::count_if(all.begin(), all.end(), [&](double l) { return l > luminance; });
  return static_cast<double>(above) / static_cast<double>(std::max<size_t>(1, all.size()));
}

std::optional<double> grey_exposure(const Image& linear, WorkingSpace space) {
  constexpr double kGrey = 0.18;
  double sum = 0;
  size_t lit = 0;
  for (const double luminance : luminance_of_pixels(linear, space)) {
    if (!(luminance > 0)) continue;
    sum += maths::log(luminance);
    ++lit;
  }
  if (lit == 0) return {};
  return (maths::log(kGrey) - sum / static_cast<double>(lit)) / kNaturalLog2;
}

std::optional<double> metered_exposure(const Image& linear, WorkingSpace space) {
  constexpr double kLit = 1.0 / 16, kMiddle = 0.16, kHighlight = 6;
  std::vector<double> all = luminance_of_pixels(linear, space);
  std::sort(all.begin(), all.end());
  if (all.empty() || !(all.back() > 0)) return {};
  const double bright = percentile(all, 0.9);
  const auto first = std::upper_bound(all.begin(), all.end(), kLit * bright);
  const std::vector<double> lit(first, all.end());
  return stops_of(std::min(kMiddle / percentile(lit, 0.5), kHighlight / percentile(all, 0.995)));
}

}  // namespace vug::image

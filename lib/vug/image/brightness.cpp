// SPDX-License-Identifier: Apache-2.0
#include <vug/base/log2.h>
#include <vug/image/brightness.h>
#include <vug/image/colour_channels.h>

#include <vector>

namespace vug::image {
namespace {

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

/// The value below which the fraction `share` of the values lies; reorders them.
double percentile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
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
  return (maths::log(kGrey) - sum / static_cast<double>(lit)) / maths::kLn2;
}

std::optional<double> metered_exposure(const Image& linear, WorkingSpace space) {
  constexpr double kLit = 1.0 / 16, kMiddle = 0.16, kHighlight = 6;
  std::vector<double> all = luminance_of_pixels(linear, space);
  if (std::none_of(all.begin(), all.end(), [](double luminance) { return luminance > 0; }))
    return {};
  const double dark = kLit * percentile(all, 0.9), most = kHighlight / percentile(all, 0.995);
  std::erase_if(all, [&](double luminance) { return luminance <= dark; });
  return maths::log2(std::min(kMiddle / percentile(all, 0.5), most));
}

}  // namespace vug::image

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/log2.h>
#include <vug/base/quantile.h>
#include <vug/image/brightness.h>
#include <vug/image/colour_channels.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

std::vector<double> above(const std::vector<double>& values, double limit) {
  std::vector<double> out;
  std::copy_if(values.begin(), values.end(), std::back_inserter(out),
               [&](double value) { return value > limit; });
  return out;
}

/// The luminances of the pixels that show a surface, if the picture has enough of them; else all.
std::vector<double> of_surfaces(const Image& picture, const std::vector<double>& luminance) {
  constexpr size_t kLeast = 20;  // at least one pixel in 20
  const int alpha = picture.find_channel("A");
  if (alpha < 0) return luminance;
  const size_t channels = picture.channels.size();
  std::vector<double> out;
  for (size_t p = 0; p < luminance.size(); ++p)
    if (picture.pixels[p * channels + static_cast<size_t>(alpha)] >= 0.5f)
      out.push_back(luminance[p]);
  return out.size() * kLeast < luminance.size() ? luminance : out;
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
  std::vector<double> all = luminance_of_pixels(linear, space);
  if (std::none_of(all.begin(), all.end(), [](double luminance) { return luminance > 0; }))
    return {};
  std::vector<double> surfaces = of_surfaces(linear, all);
  const double bright = quantile(surfaces, 0.9);
  std::vector<double> lit = above(surfaces, bright / 16);
  const double share = static_cast<double>(lit.size()) / static_cast<double>(surfaces.size());
  if (lit.empty()) lit = above(all, 0);  // only the sky shines
  const double middle = 0.16 / quantile(lit, 0.5);
  double exposure = std::min(middle, 6 / quantile(all, 0.995));
  std::vector<double> reached = above(surfaces, bright / 1024);
  if (!reached.empty()) {
    const double shade = 0.06 / quantile(reached, 0.5);
    const double raised = middle * std::exp2(std::clamp(25 * (0.3 - share), 0.0, 5.0));
    exposure = std::max(exposure, std::min({shade, raised, 3 / quantile(surfaces, 0.95),
                                            8 / quantile(surfaces, 0.98)}));
  }
  return maths::log2(exposure);
}

}  // namespace vug::image

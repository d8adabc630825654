// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/image/denoise_inputs.h>
#include <vug/image/denoise_outliers.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

constexpr float kLeastAlbedo = 0.02f;

float finite_or_zero(float v) { return std::isfinite(v) ? v : 0.0f; }

PixelValues plane(const Image& picture, const std::string& channel) {
  PixelValues out(picture.pixel_count());
  const int c = picture.find_channel(channel);
  if (c < 0) return {};
  for (size_t p = 0; p < out.size(); ++p)
    out[p] = finite_or_zero(picture.pixels[p * picture.channels.size() + static_cast<size_t>(c)]);
  return out;
}

PixelValues needed(const Image& picture, const std::string& channel) {
  PixelValues out = plane(picture, channel);
  if (out.empty())
    throw Error(ErrorCode::bad_input,
                "an image without the layer '" + channel + "' cannot be denoised", {},
                "render it with the layers beauty, albedo, N, Z and variance");
  return out;
}

/// Means over 3 x 3 pixels.
PixelValues smoothed(const PixelValues& in, int width, int height) {
  PixelValues out(in.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      float sum = 0, count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
          sum += in[static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u)],
              count += 1;
      out[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
          sum / count;
    }
  return out;
}

}  // namespace

DenoiseInputs denoise_inputs(const Image& picture) {
  DenoiseInputs all;
  all.width = picture.width, all.height = picture.height;
  const char* names[] = {"R", "G", "B"};
  for (size_t c = 0; c < 3; ++c) {
    const std::string name = names[c];
    all.colour[c] = needed(picture, name);
    all.variance[c] = needed(picture, "variance." + name);
    all.albedo[c] = plane(picture, "albedo." + name);
    if (all.albedo[c].empty()) all.albedo[c].assign(picture.pixel_count(), 0.0f);
    for (size_t p = 0; p < picture.pixel_count(); ++p) {
      float& albedo = all.albedo[c][p];
      // Continuous where rock becomes black, because a step in light / albedo would be visible as
      // an outline.
      albedo = albedo > 0 ? std::max(albedo, kLeastAlbedo) : 1.0f;
      all.colour[c][p] /= albedo;
      all.variance[c][p] /= albedo * albedo;
    }
    const auto add_feature = [&](PixelValues values, float scale) {
      if (values.empty()) return;
      for (float& v : values) v *= scale;
      all.features.push_back(std::move(values));
    };
    add_feature(plane(picture, "albedo." + name), 1 / 0.1f);
    add_feature(plane(picture, std::string("N.") + "XYZ"[c]), 1 / 0.25f);
  }
  limit_outliers(all);
  for (PixelValues& variance : all.variance) {
    const PixelValues around = smoothed(variance, all.width, all.height);
    for (size_t p = 0; p < variance.size(); ++p) variance[p] = std::max(variance[p], around[p]);
  }
  // Relative differences of depth: the reciprocal slope of its logarithm is the depth itself.
  PixelValues depth = plane(picture, "Z");
  if (!depth.empty()) {
    for (float& z : depth) z = std::clamp(z, 1e-3f, 1e6f);
    // The 16th root approximates the logarithm over the depths of one image.
    for (float& z : depth) z = 16 * std::sqrt(std::sqrt(std::sqrt(std::sqrt(z)))) / 0.1f;
    all.features.push_back(std::move(depth));
  }
  return all;
}

}  // namespace vug::image

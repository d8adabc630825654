// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/image/denoise.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::image {
namespace {

constexpr int kStrip = 32;  // Lines per task.
constexpr float kLeastAlbedo = 0.02f;
constexpr float kOutlierRatio =
    2;  ///< A pixel this many times as bright as its neighbours is an outlier.
constexpr float kOutlierErrors = 3;  ///< Larger differences in standard errors are not noise.

/// One value per pixel.
using PixelValues = std::vector<float>;

struct Planes {
  int width = 0, height = 0;
  PixelValues colour[3], variance[3],
      albedo[3];                      ///< Colour and variance are those of light / albedo.
  std::vector<PixelValues> features;  ///< Scaled such that a difference of 1 is an edge.
};

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

/// Means over 3 x 3 pixels, because single variances are noisy themselves.
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

/// Clamps single bright outliers: a pixel brighter than all but one of its neighbours, within the
/// noise of its own variance, gets the value of the second brightest. The variance of an outlier is
/// about its square, so nothing distinguishes it from its surroundings, and it would become a
/// bright patch.
void clamp_outliers(Planes& all) {
  const auto luminance = [](const PixelValues* of, size_t p) {
    return 0.2126f * of[0][p] + 0.7152f * of[1][p] + 0.0722f * of[2][p];
  };
  PixelValues light(all.colour[0].size());
  for (size_t p = 0; p < light.size(); ++p) light[p] = luminance(all.colour, p);
  for (int y = 0; y < all.height; ++y)
    for (int x = 0; x < all.width; ++x) {
      const size_t p =
          static_cast<size_t>(y) * static_cast<size_t>(all.width) + static_cast<size_t>(x);
      float first = 0, second = 0;
      for (int v = std::max(0, y - 1); v <= std::min(all.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(all.width - 1, x + 1); ++u) {
          const float near = light[static_cast<size_t>(v) * static_cast<size_t>(all.width) +
                                   static_cast<size_t>(u)];
          if (u == x && v == y) continue;
          second = std::max(second, std::min(first, near));
          first = std::max(first, near);
        }
      const float excess = light[p] - second;
      if (light[p] <= kOutlierRatio * second ||
          excess * excess > kOutlierErrors * kOutlierErrors * luminance(all.variance, p))
        continue;
      const float share = second / light[p];
      for (size_t c = 0; c < 3; ++c) {
        all.colour[c][p] *= share;
        all.variance[c][p] *= share * share;
      }
    }
}

Planes planes_of(const Image& picture) {
  Planes all;
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
  clamp_outliers(all);
  for (PixelValues& variance : all.variance) variance = smoothed(variance, all.width, all.height);
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

/// Approximates exp(-x): 1 at 0, 0 from 8 on.
float falling(float x) {
  const float base = std::max(0.0f, 1 - 0.125f * std::max(0.0f, x));
  const float squared = base * base, fourth = squared * squared;
  return fourth * fourth;
}

/// Lines y0 <= y < y1 of the result.
class Strip {
 public:
  Strip(const Planes& in, const DenoiseOptions& options, int y0, int y1)
      : in_(in),
        options_(options),
        y0_(y0),
        y1_(y1),
        sums_(static_cast<size_t>((y1 - y0) * in.width) * 4) {}

  void add_shift(int dx, int dy);
  void store(Image& out) const;

 private:
  /// Squared colour distance of two pixels in units of its noise.
  float colour_distance(size_t p, size_t q) const {
    const auto k = static_cast<float>(options_.strength * options_.strength);
    float sum = 0;
    for (size_t c = 0; c < 3; ++c) {
      const float d = in_.colour[c][p] - in_.colour[c][q];
      const float vp = in_.variance[c][p], vq = in_.variance[c][q];
      sum += (d * d - (vp + std::min(vp, vq))) / (1e-12f + k * (vp + vq));
    }
    return sum / 3;
  }
  float feature_distance(size_t p, size_t q) const {
    float most = 0;
    for (const PixelValues& feature : in_.features) {
      const float d = feature[p] - feature[q];
      most = std::max(most, d * d);
    }
    return most;
  }
  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(in_.width) + static_cast<size_t>(x);
  }

  const Planes& in_;
  const DenoiseOptions& options_;
  int y0_, y1_;
  std::vector<float> sums_;  ///< R, G, B and weight.
  PixelValues distances_, rows_;
};

void Strip::add_shift(int dx, int dy) {
  const int patch = options_.patch, width = in_.width, height = in_.height;
  // Distances between pixels and their shifted counterparts, for the lines that patches cover.
  const int top = std::max(y0_ - patch, std::max(0, -dy));
  const int bottom = std::min(y1_ + patch, std::min(height, height - dy));
  const int left = std::max(0, -dx), right = std::min(width, width - dx);
  if (top >= bottom || left >= right) return;
  distances_.resize(static_cast<size_t>((bottom - top) * width));
  rows_.resize(distances_.size());
  const auto local = [&](int x, int y) { return static_cast<size_t>((y - top) * width + x); };
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      distances_[local(x, y)] = colour_distance(at(x, y), at(x + dx, y + dy));
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      float sum = 0;
      const int from = std::max(left, x - patch), to = std::min(right - 1, x + patch);
      for (int u = from; u <= to; ++u) sum += distances_[local(u, y)];
      rows_[local(x, y)] = sum / static_cast<float>(to - from + 1);
    }
  for (int y = std::max(top, y0_); y < std::min(bottom, y1_); ++y) {
    const int from = std::max(top, y - patch), to = std::min(bottom - 1, y + patch);
    for (int x = left; x < right; ++x) {
      float sum = 0;
      for (int v = from; v <= to; ++v) sum += rows_[local(x, v)];
      const size_t q = at(x + dx, y + dy);
      const float weight = std::min(falling(sum / static_cast<float>(to - from + 1)),
                                    falling(feature_distance(at(x, y), q)));
      float* sums = &sums_[static_cast<size_t>((y - y0_) * width + x) * 4];
      for (size_t c = 0; c < 3; ++c) sums[c] += weight * in_.colour[c][q];
      sums[3] += weight;
    }
  }
}

void Strip::store(Image& out) const {
  for (int y = y0_; y < y1_; ++y)
    for (int x = 0; x < in_.width; ++x) {
      const float* sums = &sums_[static_cast<size_t>((y - y0_) * in_.width + x) * 4];
      // The weight of the pixel itself is 1, so the sum of weights is never 0.
      for (size_t c = 0; c < 3; ++c) out.at(x, y, c) = sums[c] / sums[3] * in_.albedo[c][at(x, y)];
    }
}

}  // namespace

const std::vector<std::string>& denoising_layers() {
  static const std::vector<std::string> layers = {"albedo", "N", "Z", "variance"};
  return layers;
}

Image denoise(const Image& picture, const DenoiseOptions& options, Progress& progress) {
  const Planes in = planes_of(picture);
  Image out(picture.width, picture.height, {"denoised.R", "denoised.G", "denoised.B"});
  const auto strips = static_cast<size_t>((picture.height + kStrip - 1) / kStrip);
  progress.begin("denoising", strips);
  parallel_for(strips, [&](size_t index) {
    const int y0 = static_cast<int>(index) * kStrip;
    Strip strip(in, options, y0, std::min(y0 + kStrip, picture.height));
    for (int dy = -options.window; dy <= options.window; ++dy) {
      progress.check();
      for (int dx = -options.window; dx <= options.window; ++dx) strip.add_shift(dx, dy);
    }
    strip.store(out);
    progress.advance();
  });
  progress.end();
  return out;
}

}  // namespace vug::image

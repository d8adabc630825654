// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/image/denoise.h>
#include <vug/image/denoise_inputs.h>
#include <vug/image/local_regression.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vug::image {
namespace {

constexpr int kStrip = 32;  // Lines per task.
/// A pixel's variance counts at most this many times that of the pixel it is compared with. Without
/// a limit, a pixel of high variance would be similar to every other one.
constexpr float kVarianceRatio = 8;
/// The regression removes differences that follow the features, so that only larger ones are edges.
constexpr float kFeatureShare = 0.25f;
constexpr float kLeastWeight = 1e-5f;  ///< Smaller ones are left out, for speed.

/// Approximates exp(-x): 1 at 0, 0 from 8 on.
float falling(float x) {
  const float base = std::max(0.0f, 1 - 0.125f * std::max(0.0f, x));
  const float squared = base * base, fourth = squared * squared;
  return fourth * fourth;
}

/// The weight of a pixel by its squared distance, so that the window has no edge.
float nearness(int squared, const DenoiseOptions& options) {
  return static_cast<float>(maths::exp(-0.5 * squared / (options.deviation * options.deviation)));
}

/// Lines y0 <= y < y1 of the result.
class Strip {
 public:
  Strip(const DenoiseInputs& in, const DenoiseOptions& options, int y0, int y1)
      : in_(in),
        options_(options),
        y0_(y0),
        y1_(y1),
        fit_(static_cast<size_t>((y1 - y0) * in.width), 3 + in.features.size()) {}

  /// `nearness`: the weight of that distance in pixels.
  void add_shift(int dx, int dy, float nearness);
  void store(Image& out) const;

 private:
  void add(int x, int y, int dx, int dy, float weight);
  /// Squared colour distance of two pixels in units of its noise.
  float colour_distance(size_t p, size_t q) const {
    const auto k = static_cast<float>(options_.strength * options_.strength);
    float sum = 0;
    for (size_t c = 0; c < 3; ++c) {
      const float d = in_.colour[c][p] - in_.colour[c][q];
      const float vp = in_.variance[c][p], vq = in_.variance[c][q];
      const float low = std::min(vp, vq), high = std::min(std::max(vp, vq), kVarianceRatio * low);
      sum += (d * d - 2 * low) / (1e-12f + k * (low + high));
    }
    return sum / 3;
  }
  float feature_distance(size_t p, size_t q) const {
    float most = 0;
    for (const PixelValues& feature : in_.features) {
      const float d = kFeatureShare * (feature[p] - feature[q]);
      most = std::max(most, d * d);
    }
    return most;
  }
  const DenoiseInputs& in_;
  const DenoiseOptions& options_;
  int y0_, y1_;
  LocalRegression fit_;
  PixelValues distances_, rows_;
};

void Strip::add_shift(int dx, int dy, float nearness) {
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
      distances_[local(x, y)] = colour_distance(in_.at(x, y), in_.at(x + dx, y + dy));
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
      const size_t q = in_.at(x + dx, y + dy);
      const float weight = nearness * std::min(falling(sum / static_cast<float>(to - from + 1)),
                                               falling(feature_distance(in_.at(x, y), q)));
      if (weight > kLeastWeight) add(x, y, dx, dy, weight);
    }
  }
}

void Strip::add(int x, int y, int dx, int dy, float weight) {
  const size_t p = in_.at(x, y), q = in_.at(x + dx, y + dy);
  // Smaller than features, so that the ridge damps slopes over positions more: at the border of the
  // picture they are extrapolations.
  const auto scale = 0.5f / static_cast<float>(std::max(1, options_.window));
  std::array<float, LocalRegression::kMostUnknowns> at{1, scale * static_cast<float>(dx),
                                                       scale * static_cast<float>(dy)};
  size_t i = 3;
  for (const PixelValues& feature : in_.features) at[i++] = feature[q] - feature[p];
  const float colour[3] = {in_.colour[0][q], in_.colour[1][q], in_.colour[2][q]};
  fit_.add(static_cast<size_t>((y - y0_) * in_.width + x), weight, at.data(), colour);
}

void Strip::store(Image& out) const {
  for (int y = y0_; y < y1_; ++y)
    for (int x = 0; x < in_.width; ++x) {
      float colour[3];
      fit_.solve(static_cast<size_t>((y - y0_) * in_.width + x), colour);
      for (size_t c = 0; c < 3; ++c) out.at(x, y, c) = colour[c] * in_.albedo[c][in_.at(x, y)];
    }
}

}  // namespace

const std::vector<std::string>& denoising_layers() {
  static const std::vector<std::string> layers = {"albedo", "N", "Z", "variance"};
  return layers;
}

Image denoise(const Image& picture, const DenoiseOptions& options, Progress& progress) {
  const DenoiseInputs in = denoise_inputs(picture);
  Image out(picture.width, picture.height, {"denoised.R", "denoised.G", "denoised.B"});
  const auto strips = static_cast<size_t>((picture.height + kStrip - 1) / kStrip);
  progress.begin("denoising", strips);
  parallel_for(strips, [&](size_t index) {
    const int y0 = static_cast<int>(index) * kStrip;
    Strip strip(in, options, y0, std::min(y0 + kStrip, picture.height));
    for (int dy = -options.window; dy <= options.window; ++dy) {
      progress.check();
      for (int dx = -options.window; dx <= options.window; ++dx) {
        const int squared = dx * dx + dy * dy;
        if (squared <= options.window * options.window)
          strip.add_shift(dx, dy, nearness(squared, options));
      }
    }
    strip.store(out);
    progress.advance();
  });
  progress.end();
  return out;
}

}  // namespace vug::image

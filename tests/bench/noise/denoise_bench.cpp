// SPDX-License-Identifier: Apache-2.0
// Denoising of noisy pictures, compared with a picture of many samples and with plain non-local
// means. Prints for each: HDR-FLIP, relative RMSE, and the mean relative to the reference.
//   bench_denoise NOISY.exr REFERENCE.exr [NOISY REFERENCE ...]
#include <vug/image/denoise.h>
#include <vug/image/io.h>
#include <vug/image/measure.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace {

using namespace vug;
using image::Image;

const std::vector<std::string> kRgb = {"R", "G", "B"};

/// Non-local means of the colours alone (Buades, Coll, Morel 2005): patches of 5 x 5, a window of
/// 17 x 17, and the mean variance of the picture as its noise.
Image plain_non_local_means(const Image& noisy) {
  const Image in = noisy.select(kRgb);
  const Image variances = noisy.select({"variance.R", "variance.G", "variance.B"});
  double noise = 0;
  for (const float v : variances.pixels) noise += static_cast<double>(v);
  noise /= static_cast<double>(variances.pixels.size());
  Image out = in;
  const auto clamped = [](int i, int size) { return std::clamp(i, 0, size - 1); };
  const auto distance = [&](int x, int y, int u, int v) {
    double sum = 0;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx)
        for (size_t c = 0; c < 3; ++c) {
          const auto d =
              static_cast<double>(in.at(clamped(x + dx, in.width), clamped(y + dy, in.height), c) -
                                  in.at(clamped(u + dx, in.width), clamped(v + dy, in.height), c));
          sum += d * d;
        }
    return std::max(0.0, sum / 75 - 2 * noise);
  };
  for (int y = 0; y < in.height; ++y)
    for (int x = 0; x < in.width; ++x) {
      double sum[3] = {}, total = 0;
      for (int v = std::max(0, y - 8); v <= std::min(in.height - 1, y + 8); ++v)
        for (int u = std::max(0, x - 8); u <= std::min(in.width - 1, x + 8); ++u) {
          const double weight = std::exp(-distance(x, y, u, v) / (0.36 * noise + 1e-30));
          for (size_t c = 0; c < 3; ++c) sum[c] += weight * static_cast<double>(in.at(u, v, c));
          total += weight;
        }
      for (size_t c = 0; c < 3; ++c) out.at(x, y, c) = static_cast<float>(sum[c] / total);
    }
  return out;
}

double mean(const Image& picture) {
  double sum = 0;
  for (const float v : picture.pixels) sum += static_cast<double>(v);
  return sum / static_cast<double>(picture.pixels.size());
}

void report(const char* name, Image picture, const Image& reference) {
  picture.channels = kRgb;
  fmt::print("  {:9} FLIP {:.4f}  relative RMSE {:.3f}  mean {:.3f}\n", name,
             image::measure("flip_hdr", reference, picture),
             image::measure("relative_rmse", reference, picture), mean(picture) / mean(reference));
}

}  // namespace

int main(int count, char** arguments) {
  for (int i = 1; i + 1 < count; i += 2) {
    const Image noisy = image::read(arguments[i]);
    const Image reference = image::read(arguments[i + 1]).select(kRgb);
    const auto begin = std::chrono::steady_clock::now();
    const Image denoised = image::denoise(noisy);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    fmt::print("{} ({:.2f} s)\n", arguments[i], taken.count());
    report("noisy", noisy.select(kRgb), reference);
    report("plain", plain_non_local_means(noisy), reference);
    report("denoised", denoised, reference);
  }
}

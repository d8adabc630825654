// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/image/planes.h>

#include <algorithm>

namespace vug::image {

Kernel gaussian(double sigma, int radius) {
  Kernel out;
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) {
    out.push_back(maths::exp(-0.5 * x * x / (sigma * sigma)));
    sum += out.back();
  }
  for (double& weight : out) weight /= sum;
  return out;
}

Plane filtered(const Plane& in, const Kernel& across, const Kernel& down) {
  const auto width = static_cast<size_t>(in.width);
  const auto at = [](int v, int size) { return static_cast<size_t>(std::clamp(v, 0, size - 1)); };
  const int reach = static_cast<int>(across.size() / 2), depth = static_cast<int>(down.size() / 2);
  Plane rows = in, out = in;
  parallel_for(
      static_cast<size_t>(in.height),
      [&](size_t y) {
        const float* row = &in.values[y * width];
        for (int x = 0; x < in.width; ++x) {
          double sum = 0;
          for (int i = -reach; i <= reach; ++i)
            sum += across[static_cast<size_t>(i + reach)] *
                   static_cast<double>(row[at(x + i, in.width)]);
          rows.values[y * width + static_cast<size_t>(x)] = static_cast<float>(sum);
        }
      },
      8);
  parallel_for(
      static_cast<size_t>(in.height),
      [&](size_t y) {
        std::vector<double> sums(width, 0.0);
        for (int j = -depth; j <= depth; ++j) {
          const float* row = &rows.values[at(static_cast<int>(y) + j, in.height) * width];
          const double weight = down[static_cast<size_t>(j + depth)];
          for (size_t x = 0; x < width; ++x) sums[x] += weight * static_cast<double>(row[x]);
        }
        for (size_t x = 0; x < width; ++x) out.values[y * width + x] = static_cast<float>(sums[x]);
      },
      8);
  return out;
}

Plane plane_of(const Image& image, size_t channel) {
  Plane out{image.width, image.height, std::vector<float>(image.pixel_count())};
  for (size_t p = 0; p < out.values.size(); ++p)
    out.values[p] = image.pixels[p * image.channels.size() + channel];
  return out;
}

}  // namespace vug::image

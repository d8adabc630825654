// SPDX-License-Identifier: Apache-2.0
// Structural similarity (wang2004ssim, eq. 13 with its constants) of the displayed luminance, in
// [0, 1]. The window is a Gaussian of 11 x 11 pixels, sigma 1.5. As in the paper's own programs the
// mean is taken where the whole window lies inside the image; for an image too small for that, over
// the whole image.
#include <vug/image/measure_kind.h>
#include <vug/image/planes.h>

namespace vug::image {
namespace {

constexpr int kRadius = 5;
constexpr double kSigma = 1.5, kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

Plane luminance(const Image& picture, const ViewOptions& view) {
  const Image shown = display(picture, view);
  Plane out{shown.width, shown.height, std::vector<float>(shown.pixel_count())};
  for (size_t p = 0; p < out.values.size(); ++p)
    out.values[p] = 0.2126f * shown.pixels[3 * p] + 0.7152f * shown.pixels[3 * p + 1] +
                    0.0722f * shown.pixels[3 * p + 2];
  return out;
}

Plane product(const Plane& a, const Plane& b) {
  Plane out = a;
  for (size_t p = 0; p < out.values.size(); ++p) out.values[p] *= b.values[p];
  return out;
}

MeasureResult ssim(const Comparison& pair) {
  const Plane a = luminance(pair.reference, pair.view), b = luminance(pair.test, pair.view);
  const Kernel window = gaussian(kSigma, kRadius);
  const auto local = [&](const Plane& plane) { return filtered(plane, window, window); };
  const Plane mean_a = local(a), mean_b = local(b);
  const Plane aa = local(product(a, a)), bb = local(product(b, b)), ab = local(product(a, b));
  MeasureResult out;
  out.map.resize(a.values.size());
  for (size_t p = 0; p < out.map.size(); ++p) {
    const auto ma = static_cast<double>(mean_a.values[p]),
               mb = static_cast<double>(mean_b.values[p]);
    const double va = static_cast<double>(aa.values[p]) - ma * ma;
    const double vb = static_cast<double>(bb.values[p]) - mb * mb;
    const double covariance = static_cast<double>(ab.values[p]) - ma * mb;
    out.map[p] = static_cast<float>((2 * ma * mb + kC1) * (2 * covariance + kC2) /
                                    ((ma * ma + mb * mb + kC1) * (va + vb + kC2)));
  }
  Comparison inner;
  inner.mask.assign(out.map.size(), 0);
  bool any = false;
  for (int y = kRadius; y < a.height - kRadius; ++y)
    for (int x = kRadius; x < a.width - kRadius; ++x) {
      const size_t p =
          static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x);
      inner.mask[p] = pair.counts(p) ? 1 : 0;
      any = any || inner.mask[p] != 0;
    }
  out.value = pooled_mean(any ? inner : pair, out.map);
  return out;
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(ssim) {
  return higher_is_better("ssim",
                          "Structural similarity of the displayed luminance; 1 for equal images.",
                          "wang2004ssim", 1, ssim);
}

// SPDX-License-Identifier: Apache-2.0
// LDR-FLIP of the displayed images: after the view transform at the exposure of the comparison.
#include <vug/base/srgb.h>
#include <vug/image/flip.h>
#include <vug/image/measure_kind.h>

namespace vug::image {
namespace {

/// The light emitted by a display of the image.
Image screen_light(const Image& picture, const ViewOptions& view) {
  Image shown = display(picture, view);
  for (float& v : shown.pixels) v = static_cast<float>(srgb_decode(static_cast<double>(v)));
  return shown;
}

MeasureResult ldr_flip(const Comparison& pair) {
  MeasureResult out;
  out.map =
      flip(screen_light(pair.reference, pair.view), screen_light(pair.test, pair.view)).values;
  out.value = pooled_mean(pair, out.map);
  return out;
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(flip) {
  return lower_is_better("flip",
                         "LDR-FLIP of the displayed images, mean over the pixels, in [0, 1].",
                         "andersson2020flip", ldr_flip, true);
}

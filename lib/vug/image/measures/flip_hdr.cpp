// SPDX-License-Identifier: Apache-2.0
// HDR-FLIP. The paper derives the range of exposures from the reference; the default here is the
// union of both images' ranges, so that the measure is symmetric.
#include <vug/image/flip.h>
#include <vug/image/measure_kind.h>

#include <algorithm>

namespace vug::image {
namespace {

MeasureResult hdr_flip(const Comparison& pair) {
  const Image reference = in_rec709(pair.reference, pair.view.space);
  const Image test = in_rec709(pair.test, pair.view.space);
  std::optional<ExposureRange> range = exposure_range(reference);
  if (!pair.reference_exposures || !range)
    if (const auto other = exposure_range(test)) {
      if (!range) range = other;
      range->start = std::min(range->start, other->start);
      range->stop = std::max(range->stop, other->stop);
    }
  MeasureResult out;
  if (!range) return out;  // Both images are black.
  out.map = flip_hdr(reference, test, *range).values;
  out.value = pooled_mean(pair, out.map);
  return out;
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(flip_hdr) {
  return lower_is_better("flip_hdr",
                         "HDR-FLIP over all exposures, mean over the pixels, in [0, 1].",
                         "andersson2021flip", hdr_flip, true);
}

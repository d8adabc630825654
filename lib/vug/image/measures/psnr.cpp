// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/image/measure_kind.h>

namespace vug::image {
namespace {

constexpr double kLog10 = 2.302585092994045684;

MeasureResult psnr(const Comparison& pair) {
  Comparison shown;
  shown.reference = display(pair.reference, pair.view);
  shown.test = display(pair.test, pair.view);
  shown.mask = pair.mask;
  const double squares = differences(shown).squares;
  return {squares > 0 ? 10 * maths::log(1 / squares) / kLog10 : kInfinity, {}};
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(psnr) {
  return higher_is_better("psnr",
                          "Peak signal-to-noise ratio in dB of R, G, B as displayed (peak 1); "
                          "infinite for equal images.",
                          "", kInfinity, psnr);
}

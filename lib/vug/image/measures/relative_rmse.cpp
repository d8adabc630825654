// SPDX-License-Identifier: Apache-2.0
// Relative to the content of both images, not to the reference alone, so that the measure is
// symmetric.
#include <vug/image/measure_kind.h>

#include <cmath>

namespace vug::image {
namespace {

MeasureResult relative_rmse(const Comparison& pair) {
  const Differences d = differences(pair);
  if (!(d.squares > 0)) return {};
  return {d.magnitude > 0 ? std::sqrt(d.squares) / d.magnitude : kInfinity, {}};
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(relative_rmse) {
  return lower_is_better("relative_rmse",
                         "rmse relative to the mean absolute value of both images.", "",
                         relative_rmse);
}

// SPDX-License-Identifier: Apache-2.0
#include <vug/image/measure_kind.h>

namespace vug::image {
namespace {

MeasureResult mean(const Comparison& pair) { return {differences(pair).mean, {}}; }

}  // namespace
}  // namespace vug::image

VUG_MEASURE(mean) {
  return lower_is_better("mean", "Mean absolute difference of all values.", "", mean);
}

// SPDX-License-Identifier: Apache-2.0
#include <vug/image/measure_kind.h>

namespace vug::image {
namespace {

MeasureResult largest(const Comparison& pair) {
  Differences d = differences(pair);
  return {d.largest, std::move(d.largest_of_pixel)};
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(max) {
  return lower_is_better("max", "Largest absolute difference of two values.", "", largest);
}

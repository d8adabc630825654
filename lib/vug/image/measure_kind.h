// SPDX-License-Identifier: Apache-2.0
// Definitions for the source file of a measure. The macro opens its one exported definition,
// outside of any namespace:
//   VUG_MEASURE(rmse) { return lower_is_better("rmse", "...", "", measure); }
#pragma once

#include <vug/base/kind.h>
#include <vug/image/measure.h>

#define VUG_MEASURE(name) VUG_EXPORT_KIND(vug::image, Measure, name##_measure)

namespace vug::image {

inline Measure lower_is_better(std::string name, std::string doc, std::string cite,
                               MeasureResult (*measure)(const Comparison&),
                               bool needs_colour = false) {
  return {{std::move(name), "measure", std::move(doc), std::move(cite), {}},
          Measure::Better::low,
          needs_colour,
          0,
          measure};
}

inline Measure higher_is_better(std::string name, std::string doc, std::string cite, double equal,
                                MeasureResult (*measure)(const Comparison&),
                                bool needs_colour = true) {
  return {{std::move(name), "measure", std::move(doc), std::move(cite), {}},
          Measure::Better::high,
          needs_colour,
          equal,
          measure};
}

}  // namespace vug::image

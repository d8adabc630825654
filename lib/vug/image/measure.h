// SPDX-License-Identifier: Apache-2.0
// Interface of measures of the difference between two images, as a number and as a map.
#pragma once

#include <vug/base/schema.h>
#include <vug/image/image.h>
#include <vug/image/view.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vug::image {

/// One layer of two images as input of a measure: same size and channels, names without the layer.
/// Perceptual measures apply `view` first.
struct Comparison {
  Image reference;
  Image test;
  std::vector<uint8_t> mask;  ///< Non-zero for pixels to compare, row by row; empty: all.
  ViewOptions view;
  /// HDR-FLIP takes its exposures from the reference alone, as in its paper, and is then not
  /// symmetric; otherwise from both images.
  bool reference_exposures = false;

  size_t pixel_count() const { return reference.pixel_count(); }
  bool counts(size_t pixel) const { return mask.empty() || mask[pixel] != 0; }
};

struct MeasureResult {
  double value = 0;
  std::vector<float>
      map;  ///< One value per pixel, including masked ones; empty if the measure has no map.
};

/// A kind of measure. It is symmetric in the two images and returns `equal` for equal ones.
struct Measure {
  enum class Better { low, high };

  KindInfo info;
  Better better = Better::low;
  bool needs_colour = false;  ///< Requires a layer with R, G and B.
  double equal = 0;           ///< The value for two equal images.
  MeasureResult (*measure)(const Comparison&) = nullptr;
};

const std::vector<const Measure*>& measures();
/// Returns the measure with this name; throws Error(bad_input) with the nearest name for an unknown
/// one.
const Measure& measure_of(const std::string& name);
/// Computes one measure over all channels and pixels. Throws Error(bad_input) if sizes or channels
/// differ.
double measure(const std::string& name, const Image& reference, const Image& test);

/// Throws Error(bad_input) with a full sentence if sizes or channels differ.
void require_comparable(const Image& reference, const Image& test);

/// The mean of the map over the compared pixels; 0 without such pixels.
double pooled_mean(const Comparison& pair, const std::vector<float>& map);

/// Differences of the compared values, channel by channel. Two equal infinities or two NaN have no
/// difference; any other pair with a value that is not finite differs infinitely.
struct Differences {
  double squares = 0;     ///< Mean of squared differences.
  double mean = 0;        ///< Mean of absolute differences.
  double largest = 0;     ///< Largest absolute difference.
  double magnitude = 0;   ///< Mean absolute value of both images.
  size_t not_finite = 0;  ///< Values that are NaN or infinite in at least one image.
  std::vector<float>
      largest_of_pixel;  ///< Largest absolute difference over the channels of each pixel.
};
Differences differences(const Comparison& pair);

}  // namespace vug::image

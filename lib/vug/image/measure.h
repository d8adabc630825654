// How far two pictures are apart, in numbers and as a map of where.
#pragma once

#include <vug/base/schema.h>
#include <vug/image/image.h>
#include <vug/image/view.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vug::image {

/// One layer of two pictures as a measure sees it: same size, same channels, without the layer's
/// name. Measures that need an eye look at it through `view`.
struct Comparison {
  Image reference;
  Image test;
  std::vector<uint8_t> mask;  ///< Pixels that count (not 0), row by row; empty: all of them.
  ViewOptions view;
  /// HDR-FLIP takes its exposures from the reference alone, as its paper does, and then tells
  /// reference from test; else from both.
  bool reference_exposures = false;

  size_t pixel_count() const { return reference.pixel_count(); }
  bool counts(size_t pixel) const { return mask.empty() || mask[pixel] != 0; }
};

struct MeasureResult {
  double value = 0;
  std::vector<float> map;  ///< For each pixel, masked ones too; empty when there is no such map.
};

/// A kind of measure. Symmetric in the two pictures, and `equal` for equal ones.
struct Measure {
  enum class Better { low, high };

  KindInfo info;
  Better better = Better::low;
  bool needs_colour = false;  ///< Only for layers with R, G and B.
  double equal = 0;           ///< The value of two equal pictures.
  MeasureResult (*measure)(const Comparison&) = nullptr;
};

const std::vector<const Measure*>& measures();
/// By name; Error(bad_input) with the nearest one when there is none.
const Measure& measure_of(const std::string& name);
/// One value without ado: pictures of any channels, all pixels. Error(bad_input) when sizes or
/// channels differ.
double measure(const std::string& name, const Image& reference, const Image& test);

/// Error(bad_input), in a sentence, where sizes or channels differ.
void require_comparable(const Image& reference, const Image& test);

/// The mean of the map over the pixels that count; 0 without any.
double pooled_mean(const Comparison& pair, const std::vector<float>& map);

/// Differences of the values that count, channel by channel. Where both are the same infinity or
/// both NaN there is no difference; any other pair with one that is not finite is infinitely apart.
struct Differences {
  double squares = 0;     ///< Mean of squared differences.
  double mean = 0;        ///< Mean of differences without sign.
  double largest = 0;     ///< Of differences without sign.
  double magnitude = 0;   ///< Mean of all values of both pictures without sign.
  size_t not_finite = 0;  ///< Values that are NaN or infinite in one picture at least.
  std::vector<float> largest_of_pixel;  ///< Over the pixel's channels.
};
Differences differences(const Comparison& pair);

}  // namespace vug::image

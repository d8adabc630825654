// SPDX-License-Identifier: Apache-2.0
// Pixel labels from probability maps and the tree fitted to them.
#pragma once

#include <vug/fit/fit_facade.h>
#include <vug/fit/learning/labelled_images.h>
#include <vug/fit/learning/pixel_classifier.h>

namespace vug::fit {

/// The class with the highest probability, per pixel.
std::vector<uint8_t> most_likely_classes(const Planes& maps);

struct LabellingOptions {
  /// Log2 odds by which the tree raises the classes that it shows at a pixel and lowers those that
  /// it does not. Maps know more about a single pixel, rectangles about its neighbours.
  double tree_bias = 1;
};

/// The most likely class of each pixel, given the maps and the elements of a tree. Classes without
/// a region type compete where the tree shows wall. Error(bad_input) if the maps do not match the
/// classes.
std::vector<uint8_t> label_pixels(const Planes& maps, const Classes& classes,
                                  const std::vector<DetectedElement>& seen,
                                  const LabellingOptions& options = {});

/// The RegionType of each pixel as drawn by the elements; later elements overwrite earlier ones.
std::vector<uint8_t> region_map(const std::vector<DetectedElement>& seen, int width, int height);

}  // namespace vug::fit

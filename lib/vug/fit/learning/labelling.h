// Which class each pixel is of, by maps and by the tree that was fitted to them.
#pragma once

#include <vug/fit/fit_facade.h>
#include <vug/fit/learning/labelled_images.h>
#include <vug/fit/learning/pixel_classifier.h>

namespace vug::fit {

/// The most likely class of each pixel.
std::vector<uint8_t> most_likely_classes(const Planes& maps);

struct LabellingOptions {
  /// Bits that pixels are more likely of what the tree says than maps tell, and less likely of what
  /// it does not say: they know more of a pixel than a rectangle does, which knows of its
  /// neighbours.
  double tree_bias = 1;
};

/// The most likely class of each pixel, given maps and what a tree has in the picture. Classes
/// that are no look of a tree compete where the tree has its wall. Error(bad_input) where the maps
/// are not those of the classes.
std::vector<uint8_t> label_pixels(const Planes& maps, const Classes& classes,
                                  const std::vector<DetectedElement>& seen,
                                  const LabellingOptions& options = {});

/// The picture of what is seen: the Look of each pixel, the later of `seen` over the earlier.
std::vector<uint8_t> region_map(const std::vector<DetectedElement>& seen, int width, int height);

/// The classes as an 8-bit grey PNG, as read_labelled reads them. Error(io), Error(bad_input) as
/// image::write_png.
void write_labels(const std::filesystem::path& path, const std::vector<uint8_t>& labels, int width,
                  int height);

}  // namespace vug::fit

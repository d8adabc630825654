// SPDX-License-Identifier: Apache-2.0
// Layers of an image, by EXR's naming convention: "albedo.R" is channel R of the layer "albedo".
#pragma once

#include <vug/image/image.h>

#include <string>
#include <vector>

namespace vug::image {

/// Name of the layer of the unprefixed channels R, G and B.
inline constexpr const char* kBeauty = "beauty";
/// Squared standard error of each pixel's mean of R, G and B (variance.R, ...).
inline constexpr const char* kVariance = "variance";

struct Layer {
  std::string name;
  std::vector<std::string> channels;  ///< Full names, in the order of the image.

  /// True if the layer has the channels R, G and B, so it can be displayed as a colour.
  bool colour() const;
  bool operator==(const Layer&) const = default;
};

/// The layers of an image: the beauty first, the others in channel order. A channel whose name
/// contains no dot, such as Z or A, is a layer of its own; R, G and B together are the beauty.
std::vector<Layer> layers_of(const std::vector<std::string>& channels);

/// The layer's channels, named without the layer ("R", "G", "B").
Image extract(const Image& picture, const Layer& layer);

}  // namespace vug::image

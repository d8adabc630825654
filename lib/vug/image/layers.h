// Channels of a picture gathered into layers, by EXR's convention: "albedo.R" is channel R of the
// layer "albedo".
#pragma once

#include <vug/image/image.h>

#include <string>
#include <vector>

namespace vug::image {

/// What R, G and B without a layer's name are called.
inline constexpr const char* kBeauty = "beauty";
/// Squared standard error of each pixel's mean of R, G and B (variance.R, ...).
inline constexpr const char* kVariance = "variance";

struct Layer {
  std::string name;
  std::vector<std::string> channels;  ///< Full names, in the order of the picture.

  /// True with channels R, G and B: what can be shown as a colour.
  bool colour() const;
  bool operator==(const Layer&) const = default;
};

/// The layers of a picture, beauty first, the others in the order of the channels. A channel whose
/// name has no dot, such as Z or A, is a layer of its own; R, G and B together are the beauty.
std::vector<Layer> layers_of(const std::vector<std::string>& channels);

/// The layer's channels, named without the layer ("R", "G", "B").
Image extract(const Image& picture, const Layer& layer);

}  // namespace vug::image

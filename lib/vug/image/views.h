// SPDX-License-Identifier: Apache-2.0
// The views of a stereo image, derived from its channel names: "right.albedo.R".
#pragma once

#include <vug/image/image.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::image {

/// One eye's view. Its channels are named as those of an image with a single view.
struct View {
  std::string name;  ///< "left" or "right"; empty if the channels have no prefix.
  std::vector<std::string> channels;

  /// The full name, in the image, of one of `channels` or of a layer.
  std::string full(const std::string& name_in_view) const {
    return name.empty() ? name_in_view : name + "." + name_in_view;
  }
  bool operator==(const View&) const = default;
};

/// The unprefixed view first, which is the left one if there is a right one.
std::vector<View> views_of(const std::vector<std::string>& channels);

/// The pixels of one view.
Image extract(const Image& picture, const View& view);

/// The channels of both images, which must have the same size.
Image joined(const Image& a, const Image& b);

/// Combines both views into one image, as it is read from a file: the right eye's channels are
/// prefixed with "right.".
Image stereo_image(const Image& left, const Image& right);

/// The layer of `view` that a name refers to: "right.N" is N of the right view, "right" its
/// beauty, and "N" that of every view. None if the name belongs to another view.
std::optional<std::string> layer_in(const View& view, const std::string& layer);

}  // namespace vug::image

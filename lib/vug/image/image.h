// SPDX-License-Identifier: Apache-2.0
// Images as plain data: float pixels with named channels.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vug::image {

/// Row 0 is the top row, channels interleaved: the value of channel c of pixel (x, y) is
/// pixels[(y * width + x) * channels.size() + c]. Colours are linear Rec.709 unless an operation
/// says otherwise. Channel names follow EXR: "R", "Z", "N.X", "albedo.R" (layer.channel).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::vector<float> pixels;

  Image() = default;
  /// All pixels are 0. Throws Error(bad_input) if a size is not positive or there is no channel.
  Image(int w, int h, std::vector<std::string> names);

  size_t pixel_count() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  size_t index(int x, int y, size_t channel = 0) const {
    return (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) *
               channels.size() +
           channel;
  }
  float at(int x, int y, size_t channel = 0) const { return pixels[index(x, y, channel)]; }
  float& at(int x, int y, size_t channel = 0) { return pixels[index(x, y, channel)]; }

  /// Returns the index of a channel, or -1.
  int find_channel(std::string_view name) const;
  /// Returns an image with the named channels in that order; throws Error(bad_input) with the
  /// name of a missing channel.
  Image select(const std::vector<std::string>& names) const;

  bool operator==(const Image&) const = default;
};

}  // namespace vug::image

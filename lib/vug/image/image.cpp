// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/image/image.h>

#include <fmt/format.h>

namespace vug::image {

Image::Image(int w, int h, std::vector<std::string> names)
    : width(w), height(h), channels(std::move(names)) {
  if (w < 1 || h < 1)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("invalid image size {} x {}: width and height must be at least 1", w, h));
  if (channels.empty()) throw Error(ErrorCode::bad_input, "an image needs at least one channel");
  pixels.assign(pixel_count() * channels.size(), 0.0f);
}

int Image::find_channel(std::string_view name) const {
  for (size_t i = 0; i < channels.size(); ++i)
    if (channels[i] == name) return static_cast<int>(i);
  return -1;
}

Image Image::select(const std::vector<std::string>& names) const {
  std::vector<size_t> from;
  for (const std::string& name : names) {
    const int found = find_channel(name);
    if (found < 0)
      throw Error(ErrorCode::bad_input, fmt::format("the picture has no channel '{}'", name));
    from.push_back(static_cast<size_t>(found));
  }
  Image out(width, height, names);
  for (size_t p = 0; p < pixel_count(); ++p)
    for (size_t c = 0; c < from.size(); ++c)
      out.pixels[p * from.size() + c] = pixels[p * channels.size() + from[c]];
  return out;
}

}  // namespace vug::image

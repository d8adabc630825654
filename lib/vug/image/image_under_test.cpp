// SPDX-License-Identifier: Apache-2.0
// Reading of a picture, with its noise and its mask, for a comparison.
#include <vug/base/error.h>
#include <vug/image/diff.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::image {

ImageUnderTest read_image_under_test(const std::filesystem::path& file) {
  const FileInfo info = read_info(file);
  ImageUnderTest out;
  out.name = file.string();
  out.metadata = info.metadata;
  out.left = info.left, out.top = info.top;
  if (info.chromaticities)
    out.space = find_space(*info.chromaticities).value_or(WorkingSpace::rec709);
  out.screen = std::all_of(info.formats.begin(), info.formats.end(),
                           [](const std::string& format) { return format.rfind("uint", 0) == 0; });
  out.image = read(file, {.linear = true});
  return out;
}

std::vector<uint8_t> read_mask(const std::filesystem::path& file, int width, int height) {
  const Image image = read(file);
  if (image.width != width || image.height != height)
    throw Error(ErrorCode::bad_input,
                fmt::format("the mask '{}' has {} x {} pixels, the pictures {} x {}", file.string(),
                            image.width, image.height, width, height),
                {}, "draw the mask over one of the pictures");
  std::vector<uint8_t> out(image.pixel_count());
  for (size_t p = 0; p < out.size(); ++p)
    out[p] = image.pixels[p * image.channels.size()] >= 0.5f ? 1 : 0;
  if (std::none_of(out.begin(), out.end(), [](uint8_t v) { return v != 0; }))
    throw Error(ErrorCode::bad_input, fmt::format("the mask '{}' selects no pixel", file.string()),
                {}, "pixels count where the mask's first channel is 0.5 or more");
  return out;
}

}  // namespace vug::image

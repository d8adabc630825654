// SPDX-License-Identifier: Apache-2.0
// PNG files of a view: exposure, tone curve, dithering and quantisation to 8 bits.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/image/ocio_view.h>
#include <vug/image/png_encoder.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vug::image {
namespace {

/// Ordered dither with 16 x 16 thresholds in (-1/2, 1/2) code values: Bayer's matrix, 1973, by
/// interleaving the bits of x ^ y and y (cite bayer1973dither).
double dither(int x, int y) {
  const auto u = static_cast<unsigned>(x), v = static_cast<unsigned>(y);
  unsigned rank = 0;
  for (unsigned bit = 0; bit < 4; ++bit)
    rank |= (((u ^ v) >> bit & 1u) << (7 - 2 * bit)) | ((v >> bit & 1u) << (6 - 2 * bit));
  return (rank + 0.5) / 256 - 0.5;
}

std::vector<uint8_t> codes(const Image& shown, bool dithered) {
  std::vector<uint8_t> bytes(shown.pixels.size());
  for (int y = 0; y < shown.height; ++y)
    for (int x = 0; x < shown.width; ++x) {
      const double shift = dithered ? dither(x, y) : 0;
      for (size_t c = 0; c < 3; ++c) {
        const double code = 255 * static_cast<double>(shown.at(x, y, c)) + shift;
        bytes[shown.index(x, y, c)] =
            static_cast<uint8_t>(std::clamp(std::floor(code + 0.5), 0.0, 255.0));
      }
    }
  return bytes;
}

[[noreturn]] void refuse_empty() {
  throw Error(ErrorCode::bad_input, "an image without pixels cannot be written");
}

}  // namespace

std::vector<uint8_t> display_codes(const Image& image, const ViewOptions& view) {
  return codes(display(image, view), view.dither);
}

std::string png_bytes(const Image& image, const ViewOptions& view, const Metadata& metadata) {
  if (image.width < 1 || image.height < 1 ||
      image.pixels.size() != image.pixel_count() * image.channels.size())
    refuse_empty();
  const bool srgb = !view.ocio || view.ocio->srgb();
  return encode_png(display_codes(image, view), image.width, image.height, srgb, metadata);
}

void write_png(const std::filesystem::path& path, const Image& image, const ViewOptions& view,
               const Metadata& metadata) {
  write_text(path, png_bytes(image, view, metadata));
}

void write_grey_png(const std::filesystem::path& path, const std::vector<uint8_t>& values,
                    int width, int height) {
  if (width < 1 || height < 1 ||
      values.size() != static_cast<size_t>(width) * static_cast<size_t>(height))
    refuse_empty();
  write_text(path, encode_png(values, width, height, false, {}));
}

}  // namespace vug::image

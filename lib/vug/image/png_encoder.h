// SPDX-License-Identifier: Apache-2.0
// Internal to image/: encoding of PNG files with libpng.
#pragma once

#include <vug/image/io.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vug::image {

/// A PNG of R, G, B, or of grey, one byte each, row by row from the top, with the chunks of sRGB if
/// `srgb` and the metadata as texts. Throws Error(internal) for sizes that PNG does not allow.
std::string encode_png(const std::vector<uint8_t>& bytes, int width, int height, bool srgb,
                       const Metadata& metadata);

}  // namespace vug::image

// SPDX-License-Identifier: Apache-2.0
// Display values of a picture at the size of another one.
#pragma once

#include <cstdint>
#include <vector>

namespace vug::viewport {

/// R, G and B of each pixel, row by row from the top, from the nearest pixel of `rgb`, which has
/// the size `from_width` x `from_height`. Black if `rgb` is empty.
std::vector<uint8_t> scaled_codes(const std::vector<uint8_t>& rgb, int from_width, int from_height,
                                  int width, int height);

}  // namespace vug::viewport

// SPDX-License-Identifier: Apache-2.0
// Internal to image/: the order of the channels of a part, which a file stores alphabetically.
#pragma once

#include <string>
#include <vector>

namespace vug::image::exr {

/// Sorts channels by layers, those without a layer first; within a layer, X, Y, Z and R, G, B, A
/// are in these orders, then Z, then all others in alphabetical order. This is OpenImageIO's order.
void sort_channels(std::vector<std::string>& names);

}  // namespace vug::image::exr

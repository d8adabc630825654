// SPDX-License-Identifier: Apache-2.0
// The difference between two images in words.
#pragma once

#include <vug/image/measure.h>

#include <string>

namespace vug::image {

/// The difference of a layer of the test from the same layer of the reference, as a sentence
/// without a full stop: "red is 8 % brighter, most at the lower right", or for layers without
/// colours "Z differs in 12 % of the pixels, most at the top". Brightness is compared by the means
/// of the compared pixels, places by differences relative to the local brightness. Empty if no
/// compared value differs.
std::string describe_difference(const Comparison& pair, const std::string& layer);

}  // namespace vug::image

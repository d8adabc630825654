// SPDX-License-Identifier: Apache-2.0
// Statistics about the luminance of images.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/image/image.h>

namespace vug::image {

/// The fraction of pixels whose luminance exceeds `luminance`; 0 for images without R, G and B.
double fraction_above(const Image& linear, double luminance,
                      WorkingSpace space = WorkingSpace::rec709);

}  // namespace vug::image

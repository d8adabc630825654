// How bright pictures are.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/image/image.h>

namespace vug::image {

/// The share of pixels whose luminance is above `luminance`; 0 without R, G and B.
double fraction_above(const Image& linear, double luminance,
                      WorkingSpace space = WorkingSpace::rec709);

}  // namespace vug::image

// SPDX-License-Identifier: Apache-2.0
// Picture of a leaf for programs that show leaves as cards with an alpha channel: masks and paints
// evaluated over the flattened strip of leaf(card: true).
#pragma once

#include <vug/image/image.h>
#include <vug/paint/paint.h>

namespace vug::paint {

struct LeafPictureOptions {
  int width = 128, height = 1024;  ///< Pixels, at least 1.
  int samples = 4;                 ///< Per side of a pixel, at least 1.
};

/// Channels R, G, B, A, linear Rec.709, unpremultiplied alpha. Columns run across from -1 to 1,
/// rows from the tip (top) to the base. Colours continue outside the outline, so that downscaled
/// copies have no dark rims. Without `opacity` the leaf is opaque. The result is the same for any
/// number of threads. Error(bad_input) without a paint or with sizes below 1.
image::Image leaf_picture(const Paint& color, const Mask& opacity,
                          const LeafPictureOptions& options = {});

}  // namespace vug::paint

// The picture of a leaf for programs that know leaves as cards with an alpha channel: what masks
// and paints say over the strip of leaf(card: true), laid flat.
#pragma once

#include <vug/image/image.h>
#include <vug/paint/paint.h>

namespace vug::paint {

struct LeafPictureOptions {
  int width = 128, height = 1024;  ///< Pixels, at least 1.
  int samples = 4;                 ///< Along each side of a pixel, at least 1.
};

/// Channels R, G, B, A, linear Rec.709, alpha not multiplied in. Columns go across from -1 to 1,
/// rows along from the tip (above) to the base. Colours go on beyond the outline, so that smaller
/// copies of the picture have no dark rims. A leaf without `opacity` is all there. The same for
/// any number of threads. Error(bad_input) without a paint or with sizes below 1.
image::Image leaf_picture(const Paint& color, const Mask& opacity,
                          const LeafPictureOptions& options = {});

}  // namespace vug::paint

// SPDX-License-Identifier: Apache-2.0
// The conversion of a preview's light to display values, which can change without new rays.
#pragma once

#include <vug/image/view.h>
#include <vug/picture/picture_file.h>

#include <string>

namespace vug::viewport {

/// Changes of the display of the text's `render` block. Applies to Mode::path only: the other modes
/// have display values already.
struct DisplayChoice {
  double stops = 0;        ///< Added to the exposure of the block.
  std::string view;        ///< Instead of the view of the block; empty: that one.
  bool denoise = false;    ///< Shows the denoised light as soon as it is known.
  std::string layer = {};  ///< The layer that is shown, see shown_layer.h; empty: the beauty.

  bool operator==(const DisplayChoice&) const = default;
};

/// The options that display light of a picture. Error(bad_input) for an unknown view, listing the
/// known ones.
image::ViewOptions view_options(const DisplayChoice& choice, const picture::PictureOutput& output,
                                const image::Image& light);

}  // namespace vug::viewport

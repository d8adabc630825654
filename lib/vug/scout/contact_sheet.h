// SPDX-License-Identifier: Apache-2.0
// Small pictures of shots, side by side on one sheet.
#pragma once

#include <vug/scout/scout.h>

namespace vug::scout {

struct SheetOptions {
  int width = 320, height = 180;  ///< Size of each picture in pixels.
  int spp = 8;
  uint64_t seed = 0;
};

/// Renders a pose with the lights of the scene and `more` lights, denoises it and meters its
/// exposure; R, G and B as they are displayed by the settings' view, 0 to 1 (sRGB).
image::Image render_thumbnail(const Location& location, const picture::PicturePlan& plan,
                              const Pose& pose, const std::vector<render::LightPtr>& more,
                              const SheetOptions& options, Progress& progress = Progress::none());

/// Displayed pictures of equal size in rows of four, each with its number from 1 in a corner; for
/// image::write_png with image::plain_view().
image::Image contact_sheet(const std::vector<image::Image>& pictures);

}  // namespace vug::scout

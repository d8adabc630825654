// SPDX-License-Identifier: Apache-2.0
#include <vug/image/ocio_view.h>
#include <vug/picture/exposure.h>
#include <vug/viewport/display_choice.h>

namespace vug::viewport {

image::ViewOptions view_options(const DisplayChoice& choice, const picture::PictureOutput& output,
                                const image::Image& light) {
  image::ViewSelection selection = output.view();
  if (!choice.view.empty()) selection.view = choice.view;
  image::ViewOptions view = image::view_options(selection, output.settings.working_space);
  view.exposure = picture::exposure_stops(output.settings, light) + choice.stops;
  view.dither = false;
  return view;
}

}  // namespace vug::viewport

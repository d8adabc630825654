// SPDX-License-Identifier: Apache-2.0
// The two functions that the shared library exports.
#include <vug/image/backend.h>
#include <vug/image/backend_interface.h>

extern "C" __attribute__((visibility("default"))) const char* vug_image_files_interface() {
  return vug::image::kBackendInterface;
}

extern "C" __attribute__((visibility("default"))) const vug::image::Backend* vug_image_files() {
  using namespace vug::image;
  static constexpr Backend kFunctions = {.read = oiio::read,
                                         .read_info = oiio::read_info,
                                         .read_deep_info = oiio::read_deep_info,
                                         .texture = oiio::texture,
                                         .warp = oiio::warp,
                                         .ocio_view = oiio::ocio_view};
  return &kFunctions;
}

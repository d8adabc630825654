// SPDX-License-Identifier: Apache-2.0
// For any bytes, the picture reader returns the number of values stated in the header, or fails
// with bad_input (too_large if the picture exceeds any memory). The system's OpenEXR and
// OpenImageIO, which it calls, are not instrumented: report findings in them to their projects.
#include "file_of_bytes.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/image/io.h>

#include <cstdlib>

VUG_FUZZ_TARGET(picture) {
  const auto& path = file_of_bytes(data, size, ".exr");
  try {
    const vug::image::FileInfo info = vug::image::read_info(path);
    if (info.width < 1 || info.height < 1 || info.channels.size() != info.formats.size())
      std::abort();
    // Larger pictures would slow the fuzzer down.
    const double values =
        static_cast<double>(info.width) * info.height * static_cast<double>(info.channels.size());
    if (values > 1 << 22) return;
    const vug::image::Image image = vug::image::read(path);
    if (image.pixels.size() != image.pixel_count() * image.channels.size()) std::abort();
    if (image.channels != info.channels) std::abort();
  } catch (const vug::Error& error) {
    if (error.code() != vug::ErrorCode::bad_input && error.code() != vug::ErrorCode::too_large)
      std::abort();
    if (std::string(error.what()).find(path.string()) == std::string::npos) std::abort();
  }
}

// Whatever the bytes, the reader of pictures gives as many values as its header says, or refuses
// with bad_input (too_large for one that no machine could hold). OpenEXR and OpenImageIO below it
// are the system's, and not instrumented: a finding in them is theirs.
#include "file_of_bytes.h"

#include <vug/base/error.h>
#include <vug/image/io.h>

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto& path = file_of_bytes(data, size, ".exr");
  try {
    const vug::image::FileInfo info = vug::image::read_info(path);
    if (info.width < 1 || info.height < 1 || info.channels.size() != info.formats.size())
      std::abort();
    // Larger ones cost a fuzzer its time.
    const double values =
        static_cast<double>(info.width) * info.height * static_cast<double>(info.channels.size());
    if (values > 1 << 22) return 0;
    const vug::image::Image image = vug::image::read(path);
    if (image.pixels.size() != image.pixel_count() * image.channels.size()) std::abort();
    if (image.channels != info.channels) std::abort();
  } catch (const vug::Error& error) {
    if (error.code() != vug::ErrorCode::bad_input && error.code() != vug::ErrorCode::too_large)
      std::abort();
    if (std::string(error.what()).find(path.string()) == std::string::npos) std::abort();
  }
  return 0;
}

#include "files.h"

#include <vug/image/io.h>

namespace vug::cli {

namespace fs = std::filesystem;

std::string seen_from(const fs::path& folder, const fs::path& file) {
  return fs::absolute(file)
      .lexically_normal()
      .lexically_relative(fs::absolute(folder).lexically_normal())
      .generic_string();
}

void write_plain_png(const fs::path& file, const image::Image& picture) {
  image::ViewOptions plain;
  plain.transform = image::ViewTransform::srgb;
  plain.dither = false;
  image::write_png(file, picture, plain);
}

}  // namespace vug::cli

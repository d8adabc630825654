// SPDX-License-Identifier: Apache-2.0
// Writes EXR files through a temporary file; exr/write.cpp encodes them.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/image/exr/write.h>

namespace vug::image {
namespace {

void require_whole(const Image& image) {
  if (image.width < 1 || image.height < 1 || image.channels.empty() ||
      image.pixels.size() != image.pixel_count() * image.channels.size())
    throw Error(ErrorCode::bad_input, "an image without pixels cannot be written");
}

}  // namespace

void write_exr(const std::filesystem::path& path, const Image& image, const ExrOptions& options) {
  write_exr(path, {{"", image, options}});
}

void write_exr(const std::filesystem::path& path, const std::vector<ExrView>& views) {
  for (const ExrView& view : views) require_whole(view.image);
  AtomicFile file(path);
  exr::write_flat(path, file.path(), views);
  file.commit();
}

}  // namespace vug::image

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/image/exr/write.h>

namespace vug::image {

Image flatten(const DeepImage& deep) {
  Image out(deep.width, deep.height, {"R", "G", "B", "A"});
  for (size_t p = 0; p < deep.pixels.size(); ++p) {
    float* to = &out.pixels[4 * p];
    for (const DeepSample& sample : deep.pixels[p]) {
      const float clear = 1 - to[3];
      to[0] += clear * sample.r, to[1] += clear * sample.g, to[2] += clear * sample.b;
      to[3] += clear * sample.alpha;
    }
  }
  return out;
}

void write_deep_exr(const std::filesystem::path& path, const DeepImage& deep,
                    const ExrOptions& options) {
  write_deep_exr(path, {{"", deep, options}});
}

void write_deep_exr(const std::filesystem::path& path, const std::vector<DeepView>& views) {
  for (const DeepView& view : views)
    if (view.image.width < 1 || view.image.height < 1)
      throw Error(ErrorCode::bad_input, "an image without pixels cannot be written");
  AtomicFile file(path);
  exr::write_deep(path, file.path(), views);
  file.commit();
}

}  // namespace vug::image

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/srgb.h>
#include <vug/image/backend.h>
#include <vug/image/texture.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::image {

struct Texture::File {
  std::string name;
  int channels = 3;
  std::shared_ptr<const oiio::TextureLookup> lookup;
  bool encoded = false;  ///< sRGB.
  ColourMatrix to_rec709;
};

Texture::Texture(const std::filesystem::path& path) {
  const FileInfo info = read_info(path);
  auto file = std::make_shared<File>();
  file->name = path.string();
  file->channels = static_cast<int>(std::min<size_t>(info.channels.size(), 3));
  file->lookup = backend().texture(path, file->channels);
  const std::string format = info.formats.empty() ? "" : info.formats.front();
  file->encoded = format != "half" && format != "float" && format != "double";
  if (!file->encoded) {
    file->to_rec709 = to_rec709(info);
    const Image whole = read(path);
    const auto bad = std::find_if(whole.pixels.begin(), whole.pixels.end(),
                                  [](float x) { return !std::isfinite(x); });
    if (bad != whole.pixels.end()) {
      const auto pixel = static_cast<size_t>(bad - whole.pixels.begin()) / whole.channels.size();
      const auto width = static_cast<size_t>(whole.width);
      throw Error(
          ErrorCode::bad_input,
          fmt::format(
              "the texture '{}' contains a number that is not finite, first at pixel ({}, {})",
              path.string(), pixel % width, pixel / width));
    }
  }
  file_ = std::move(file);
}

Vec3d Texture::at(double s, double t, double width) const {
  // Integer repetitions are removed here, where it costs no precision.
  const auto x = static_cast<float>(s - std::floor(s)), y = static_cast<float>(t - std::floor(t));
  const auto w = static_cast<float>(width);
  float rgb[3] = {0, 0, 0};
  if (!file_->lookup->sample(x, y, w, rgb))
    throw Error(ErrorCode::bad_input,
                fmt::format("the texture '{}' cannot be read: its pixels are damaged or truncated",
                            file_->name),
                {}, "write it again with the program that made it");
  if (file_->channels < 3) rgb[1] = rgb[2] = rgb[0];
  Vec3d color(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]),
              static_cast<double>(rgb[2]));
  if (file_->encoded)
    for (int c = 0; c < 3; ++c) color[c] = srgb_decode(std::clamp(color[c], 0.0, 1.0));
  return file_->to_rec709(color);
}

}  // namespace vug::image

// SPDX-License-Identifier: Apache-2.0
// Reading of pictures: checks of the file, then conversion to the library's channels and colours.
#include <vug/base/atomic_file.h>
#include <vug/base/srgb.h>
#include <vug/image/backend.h>
#include <vug/image/exr/read.h>
#include <vug/image/exr_check.h>
#include <vug/image/png_check.h>
#include <vug/image/png_reader.h>
#include <vug/image/read_error.h>

namespace vug::image {
namespace {

bool is_colour(const std::string& name) { return name == "R" || name == "G" || name == "B"; }

/// Throws Error(bad_input) for a missing file and for one that must not reach the libraries.
void require_sound(const std::filesystem::path& path) {
  if (const std::string why = unreadable_reason(path); !why.empty()) throw read_error(path, why);
  for (const auto& fault_of : {exr_fault, png_fault})
    if (const std::string fault = fault_of(path); !fault.empty()) throw damage_error(path, fault);
}

/// As stored, by the lighter libraries if they can.
oiio::Pixels read_stored(const std::filesystem::path& path) {
  if (std::optional<Image> image = exr::read_flat(path)) return {std::move(*image), false};
  if (std::optional<Image> image = read_plain_png(path)) return {std::move(*image), true};
  return backend().read(path);
}

}  // namespace

Image read(const std::filesystem::path& path, const ReadOptions& options) {
  require_sound(path);
  auto [image, integers] = read_stored(path);
  if (options.linear && integers)
    for (size_t c = 0; c < image.channels.size(); ++c)
      if (is_colour(image.channels[c]))
        for (size_t i = c; i < image.pixels.size(); i += image.channels.size())
          image.pixels[i] = static_cast<float>(srgb_decode(static_cast<double>(image.pixels[i])));
  return std::move(image);
}

FileInfo read_info(const std::filesystem::path& path) {
  require_sound(path);
  if (std::optional<FileInfo> info = exr::read_flat_info(path)) return std::move(*info);
  if (std::optional<FileInfo> info = read_plain_png_info(path)) return std::move(*info);
  return backend().read_info(path);
}

std::optional<DeepInfo> read_deep_info(const std::filesystem::path& path) {
  require_sound(path);
  if (exr::read_flat_info(path) || read_plain_png_info(path)) return std::nullopt;
  return backend().read_deep_info(path);
}

ColourMatrix to_rec709(const FileInfo& file) {
  if (!file.chromaticities) return {};
  // Invalid chromaticities would give invalid colours.
  for (size_t i = 0; i < 8; ++i)
    if (!((*file.chromaticities)[i] > (i % 2 == 1 ? 1e-3 : -1.0))) return {};
  return {*file.chromaticities, info(WorkingSpace::rec709).chromaticities};
}

Image read_grey(const std::filesystem::path& path) {
  const Image all = read(path);
  if (all.channels.size() == 1) return all;
  std::vector<size_t> used;
  for (size_t c = 0; c < all.channels.size(); ++c)
    if (is_colour(all.channels[c])) used.push_back(c);
  if (used.empty()) used.push_back(0);
  Image grey(all.width, all.height, {"Y"});
  for (size_t p = 0; p < all.pixel_count(); ++p) {
    float sum = 0;
    for (const size_t c : used) sum += all.pixels[p * all.channels.size() + c];
    grey.pixels[p] = sum / static_cast<float>(used.size());
  }
  return grey;
}

}  // namespace vug::image

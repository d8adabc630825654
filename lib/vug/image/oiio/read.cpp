// SPDX-License-Identifier: Apache-2.0
// Reading of pictures and of their headers with OpenImageIO: all but plain EXR and PNG files.
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/image/backend.h>
#include <vug/image/part_channels.h>
#include <vug/image/read_error.h>

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>

namespace vug::image::oiio {
namespace {

/// The reason why the file has no reader, in terms for users; OpenImageIO's messages are for
/// programmers.
Error refuse_opening(const std::filesystem::path& path) {
  (void)OIIO::geterror();  // Otherwise OpenImageIO prints it at exit.
  const std::string ending = extension_of(path);
  // "bmp:bmp;jpeg:jpg,jpe,jpeg;..."
  std::string known = fmt::format(",{},", OIIO::get_string_attribute("extension_list"));
  for (char& c : known)
    if (c == ':' || c == ';') c = ',';
  if (ending.size() < 2 || known.find(fmt::format(",{},", ending.substr(1))) == known.npos)
    return read_error(path,
                      ending.size() < 2
                          ? "its name does not have the extension of an image format"
                          : fmt::format("no image format has the extension {}", ending),
                      "use a .exr, .png, .jpg, .hdr or .tif");
  return unreadable_beginning(path, ending);
}

Error refuse_pixels(const std::filesystem::path& path, OIIO::ImageInput& input) {
  (void)input.geterror();
  return unreadable_pixels(path);
}

std::unique_ptr<OIIO::ImageInput> open_any(const std::filesystem::path& path) {
  // Otherwise a file that the reader of its extension refuses is tried with all other readers,
  // which are many and slow, and some keep memory.
  static const bool by_ending = OIIO::attribute("try_all_readers", 0);
  (void)by_ending;
  auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw refuse_opening(path);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
    throw read_error(path, "it is not a flat image");
  require_reasonable_size(path, spec.width, spec.height, static_cast<size_t>(spec.nchannels));
  return input;
}

std::unique_ptr<OIIO::ImageInput> open_input(const std::filesystem::path& path) {
  auto input = open_any(path);
  if (input->spec().deep)
    throw read_error(path, "it is not a flat image",
                     "the flat image of a render lies next to the deep one");
  return input;
}

/// The parts with the same window as the first: those of a multi-part EXR, not the thumbnails that
/// some formats add.
std::vector<OIIO::ImageSpec> part_specs(OIIO::ImageInput& input) {
  std::vector<OIIO::ImageSpec> parts = {input.spec()};
  const bool many = std::string_view(input.format_name()) == "openexr";
  for (int i = 1; many && input.seek_subimage(i, 0); ++i) {
    const OIIO::ImageSpec& part = input.spec();
    const OIIO::ImageSpec& first = parts.front();
    if (part.deep != first.deep || part.width != first.width || part.height != first.height ||
        part.x != first.x || part.y != first.y)
      break;
    parts.push_back(part);
  }
  return parts;
}

std::vector<std::string> channels_of(const std::vector<OIIO::ImageSpec>& specs) {
  std::vector<PartChannels> parts;
  for (const OIIO::ImageSpec& spec : specs)
    parts.push_back({spec.get_string_attribute("oiio:subimagename"),
                     spec.get_string_attribute("view"), spec.channelnames});
  return channel_names(parts);
}

FileInfo info_of(const std::vector<OIIO::ImageSpec>& parts) {
  const OIIO::ImageSpec& spec = parts.front();
  FileInfo info;
  info.width = spec.width;
  info.height = spec.height;
  info.left = spec.x - spec.full_x;
  info.top = spec.y - spec.full_y;
  info.channels = channels_of(parts);
  for (const OIIO::ImageSpec& part : parts)
    for (int c = 0; c < part.nchannels; ++c)
      info.formats.emplace_back(part.channelformat(c).c_str());
  std::array<float, 8> primaries{};
  if (spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                        primaries.data()))
    std::copy(primaries.begin(), primaries.end(), info.chromaticities.emplace().begin());
  for (const OIIO::ImageSpec& part : parts)
    for (const auto& attribute : part.extra_attribs) {
      // Of numbers only those of a photograph's camera matter, such as the focal length.
      const bool photograph = attribute.name().string().rfind("Exif:", 0) == 0;
      if (attribute.type() != OIIO::TypeDesc::STRING && !photograph) continue;
      std::pair<std::string, std::string> entry(attribute.name().string(), attribute.get_string());
      if (std::find(info.metadata.begin(), info.metadata.end(), entry) == info.metadata.end())
        info.metadata.push_back(std::move(entry));
    }
  return info;
}

}  // namespace

Pixels read(const std::filesystem::path& path) {
  const auto input = open_input(path);
  const std::vector<OIIO::ImageSpec> parts = part_specs(*input);
  const OIIO::ImageSpec& spec = parts.front();
  const std::vector<std::string> channels = channels_of(parts);
  require_memory(4.0 * spec.width * spec.height * static_cast<double>(channels.size()),
                 available_memory(), fmt::format("the picture '{}'", path.string()));
  Image image(spec.width, spec.height, channels);
  const auto stride = static_cast<OIIO::stride_t>(sizeof(float) * channels.size());
  size_t channel = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    if (!input->read_image(static_cast<int>(i), 0, 0, parts[i].nchannels, OIIO::TypeDesc::FLOAT,
                           &image.pixels[channel], stride))
      throw refuse_pixels(path, *input);
    channel += static_cast<size_t>(parts[i].nchannels);
  }
  return {std::move(image), !spec.format.is_floating_point()};
}

FileInfo read_info(const std::filesystem::path& path) {
  return info_of(part_specs(*open_input(path)));
}

std::optional<DeepInfo> read_deep_info(const std::filesystem::path& path) {
  const auto input = open_any(path);
  if (!input->spec().deep) return std::nullopt;
  const std::vector<OIIO::ImageSpec> parts = part_specs(*input);
  DeepInfo info{info_of(parts)};
  constexpr double kPixelBytes = 16;  // Memory of OpenImageIO for a pixel without samples.
  require_memory(kPixelBytes * info.file.width * info.file.height, available_memory(),
                 fmt::format("the picture '{}'", path.string()));
  for (int part = 0; part < static_cast<int>(parts.size()); ++part) {
    OIIO::DeepData data;
    if (!input->read_native_deep_image(part, 0, data)) throw refuse_pixels(path, *input);
    for (int64_t pixel = 0; pixel < data.pixels(); ++pixel)
      info.samples += static_cast<uint64_t>(data.samples(pixel));
  }
  return info;
}

}  // namespace vug::image::oiio

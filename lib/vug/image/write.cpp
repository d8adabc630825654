#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/image/io.h>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace vug::image {
namespace {

void require_whole(const Image& image) {
  if (image.width < 1 || image.height < 1 || image.channels.empty() ||
      image.pixels.size() != image.pixel_count() * image.channels.size())
    throw Error(ErrorCode::bad_input, "a picture without pixels cannot be written");
}

/// Writes through a temporary file of the same extension, which tells OpenImageIO the format.
void write(const std::filesystem::path& path, OIIO::ImageSpec spec, OIIO::TypeDesc type,
           const void* pixels, const Metadata& metadata) {
  for (const auto& [name, text] : metadata) spec.attribute(name, text);
  AtomicFile file(path);
  const auto refuse = [&](const std::string& why) {
    return Error(ErrorCode::io, fmt::format("cannot write picture '{}': {}", path.string(), why));
  };
  const auto output = OIIO::ImageOutput::create(file.path().string());
  if (!output) throw refuse(OIIO::geterror());
  if (!output->open(file.path().string(), spec) || !output->write_image(type, pixels) ||
      !output->close())
    throw refuse(output->geterror());
  file.commit();
}

bool in_layer(const std::string& channel, const std::string& layer) {
  return channel == layer ||
         (channel.size() > layer.size() && channel.compare(0, layer.size(), layer) == 0 &&
          channel[layer.size()] == '.');
}

}  // namespace

void write_exr(const std::filesystem::path& path, const Image& image, const ExrOptions& options) {
  require_whole(image);
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       OIIO::TypeDesc::FLOAT);
  if (options.window.full_width > 0) {
    spec.x = options.window.x, spec.y = options.window.y;
    spec.full_width = options.window.full_width, spec.full_height = options.window.full_height;
  }
  spec.channelnames = image.channels;
  spec.alpha_channel = image.find_channel("A");
  spec.z_channel = image.find_channel("Z");
  spec.attribute("compression", "zip");
  // OpenImageIO would write the time of day: the same picture shall have the same bytes.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  spec.attribute("oiio:ColorSpace", "linear");
  if (!options.half)
    return write(path, spec, OIIO::TypeDesc::FLOAT, image.pixels.data(), options.metadata);

  Image stored = image;
  spec.format = OIIO::TypeDesc::HALF;
  for (size_t c = 0; c < image.channels.size(); ++c) {
    const bool full =
        std::any_of(options.full_channels.begin(), options.full_channels.end(),
                    [&](const std::string& layer) { return in_layer(image.channels[c], layer); });
    spec.channelformats.push_back(full ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::HALF);
    if (full) continue;
    for (size_t i = c; i < stored.pixels.size(); i += image.channels.size())
      if (std::isfinite(stored.pixels[i]))
        stored.pixels[i] = std::clamp(stored.pixels[i], -65504.0f, 65504.0f);
  }
  write(path, spec, OIIO::TypeDesc::FLOAT, stored.pixels.data(), options.metadata);
}

}  // namespace vug::image

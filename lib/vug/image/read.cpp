#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/image/io.h>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <memory>

namespace vug::image {
namespace {

/// More pixels than this times channels is taken for a broken header (64 GiB of floats).
constexpr double kMostValues = 1.6e10;

/// OpenImageIO's reason, of which it may give several, one a line.
Error refuse(const std::filesystem::path& path, const std::string& reason) {
  return Error(ErrorCode::bad_input, fmt::format("cannot read picture '{}': {}", path.string(),
                                                 reason.substr(0, reason.find('\n'))));
}

std::unique_ptr<OIIO::ImageInput> open(const std::filesystem::path& path) {
  if (const std::string why = why_no_file(path); !why.empty()) throw refuse(path, why);
  auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw refuse(path, OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.deep)
    throw refuse(path, "it is no flat picture");
  if (static_cast<double>(spec.width) * spec.height * spec.nchannels > kMostValues)
    throw refuse(path, fmt::format("its header claims {} x {} pixels", spec.width, spec.height));
  return input;
}

bool is_colour(const std::string& name) { return name == "R" || name == "G" || name == "B"; }

}  // namespace

Image read(const std::filesystem::path& path, const ReadOptions& options) {
  const auto input = open(path);
  const OIIO::ImageSpec& spec = input->spec();
  require_memory(4.0 * spec.width * spec.height * spec.nchannels, available_memory(),
                 fmt::format("the picture '{}'", path.string()));
  Image image(spec.width, spec.height, spec.channelnames);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data()))
    throw refuse(path, input->geterror());
  if (options.linear && !spec.format.is_floating_point())
    for (size_t c = 0; c < image.channels.size(); ++c)
      if (is_colour(image.channels[c]))
        for (size_t i = c; i < image.pixels.size(); i += image.channels.size())
          image.pixels[i] = static_cast<float>(srgb_decode(static_cast<double>(image.pixels[i])));
  return image;
}

FileInfo read_info(const std::filesystem::path& path) {
  const auto input = open(path);
  const OIIO::ImageSpec& spec = input->spec();
  FileInfo info;
  info.width = spec.width;
  info.height = spec.height;
  info.channels = spec.channelnames;
  for (int c = 0; c < spec.nchannels; ++c) info.formats.emplace_back(spec.channelformat(c).c_str());
  for (const auto& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeDesc::STRING)
      info.metadata.emplace_back(attribute.name().string(), attribute.get_string());
  return info;
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

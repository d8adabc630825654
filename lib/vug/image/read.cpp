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

/// Further parts that make one picture with the first: of its size, with channels of their own.
std::vector<OIIO::ImageSpec> other_parts(OIIO::ImageInput& input) {
  const OIIO::ImageSpec& first = input.spec();
  std::vector<OIIO::ImageSpec> parts;
  if (std::string(input.format_name()) != "openexr") return parts;
  for (int part = 1;; ++part) {
    const OIIO::ImageSpec spec = input.spec(part);
    if (spec.undefined()) return parts;
    if (spec.deep || spec.x != first.x || spec.y != first.y || spec.width != first.width ||
        spec.height != first.height)
      continue;
    if (static_cast<double>(spec.width) * spec.height * spec.nchannels > kMostValues) continue;
    parts.push_back(spec);
    parts.back().attribute("vug:part", part);
  }
}

/// A picture with the channels of both; where both have one, that of `a` stays.
Image joined(const Image& a, const Image& b) {
  std::vector<std::string> names = a.channels;
  std::vector<size_t> from;
  for (size_t c = 0; c < b.channels.size(); ++c)
    if (a.find_channel(b.channels[c]) < 0) {
      names.push_back(b.channels[c]);
      from.push_back(c);
    }
  Image out(a.width, a.height, names);
  float* to = out.pixels.data();
  for (size_t p = 0; p < a.pixel_count(); ++p) {
    for (size_t c = 0; c < a.channels.size(); ++c) *to++ = a.pixels[p * a.channels.size() + c];
    for (const size_t c : from) *to++ = b.pixels[p * b.channels.size() + c];
  }
  return out;
}

bool is_colour(const std::string& name) { return name == "R" || name == "G" || name == "B"; }

}  // namespace

Image read(const std::filesystem::path& path, const ReadOptions& options) {
  const auto input = open(path);
  const OIIO::ImageSpec spec = input->spec();
  const std::vector<OIIO::ImageSpec> parts = other_parts(*input);
  int channels = spec.nchannels;
  for (const OIIO::ImageSpec& part : parts) channels += part.nchannels;
  require_memory((parts.empty() ? 4.0 : 8.0) * spec.width * spec.height * channels,
                 available_memory(), fmt::format("the picture '{}'", path.string()));
  Image image(spec.width, spec.height, spec.channelnames);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data()))
    throw refuse(path, input->geterror());
  for (const OIIO::ImageSpec& part : parts) {
    Image more(part.width, part.height, part.channelnames);
    if (!input->read_image(part.get_int_attribute("vug:part"), 0, 0, part.nchannels,
                           OIIO::TypeDesc::FLOAT, more.pixels.data()))
      throw refuse(path, input->geterror());
    image = joined(image, more);
  }
  if (options.linear && !spec.format.is_floating_point())
    for (size_t c = 0; c < image.channels.size(); ++c)
      if (is_colour(image.channels[c]))
        for (size_t i = c; i < image.pixels.size(); i += image.channels.size())
          image.pixels[i] = static_cast<float>(srgb_decode(static_cast<double>(image.pixels[i])));
  return image;
}

FileInfo read_info(const std::filesystem::path& path) {
  const auto input = open(path);
  const OIIO::ImageSpec spec = input->spec();
  FileInfo info;
  info.width = spec.width;
  info.height = spec.height;
  info.channels = spec.channelnames;
  const auto take_texts = [&](const OIIO::ImageSpec& from) {
    for (const auto& attribute : from.extra_attribs)
      if (attribute.type() == OIIO::TypeDesc::STRING)
        info.metadata.emplace_back(attribute.name().string(), attribute.get_string());
  };
  for (int c = 0; c < spec.nchannels; ++c) info.formats.emplace_back(spec.channelformat(c).c_str());
  take_texts(spec);
  for (const OIIO::ImageSpec& part : other_parts(*input)) {
    for (int c = 0; c < part.nchannels; ++c) {
      info.channels.push_back(part.channelnames[static_cast<size_t>(c)]);
      info.formats.emplace_back(part.channelformat(c).c_str());
    }
    take_texts(part);
  }
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

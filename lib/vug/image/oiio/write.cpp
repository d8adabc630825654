// SPDX-License-Identifier: Apache-2.0
// Writing of EXR files with OpenImageIO: parts, channels and metadata.
#include <vug/base/error.h>
#include <vug/image/backend.h>
#include <vug/image/oiio/exr_spec.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>

namespace vug::image::oiio {
namespace {

/// `count` channels, starting at `from`, of one part of a file.
struct PartChannels {
  std::string name;
  size_t from, count;
};

/// The part name of a channel in a file with one part per layer: all of a Cryptomatte share one
/// part, and alpha belongs to the colour.
std::string part_name(const std::string& channel) {
  const size_t dot = channel.find('.');
  if (dot == std::string::npos) return channel.find_first_of("RGBA") == 0 ? "beauty" : channel;
  size_t end = dot;
  while (end > 0 && channel[end - 1] >= '0' && channel[end - 1] <= '9') --end;
  return channel.substr(0, end);
}

std::vector<PartChannels> parts_of(const std::vector<std::string>& channels, bool split) {
  std::vector<PartChannels> parts;
  for (size_t c = 0; c < channels.size(); ++c) {
    const std::string name = split ? part_name(channels[c]) : "";
    // Blender 3.4 cannot read a part with one channel and no layer, except for depth.
    const bool alone = name == channels[c] && name != "Z";
    if (parts.empty() || (parts.back().name != name && !alone))
      parts.push_back({name, c, 1});
    else
      ++parts.back().count;
  }
  return parts;
}

bool in_layer(const std::string& channel, const std::string& layer) {
  if (channel.compare(0, layer.size(), layer) != 0) return false;
  const size_t rest = channel.find_first_not_of("0123456789", layer.size());
  return rest == std::string::npos || channel[rest] == '.';
}

}  // namespace

OIIO::ImageSpec exr_spec(int width, int height, const ExrOptions& options) {
  OIIO::ImageSpec spec(width, height, 1, OIIO::TypeDesc::FLOAT);
  if (options.window.full_width > 0) {
    spec.x = options.window.x, spec.y = options.window.y;
    spec.full_width = options.window.full_width, spec.full_height = options.window.full_height;
  }
  if (options.tiles) spec.tile_width = spec.tile_height = 64;
  spec.attribute("compression", "zip");
  // A constant, because OpenImageIO would write the current time and equal images must have equal
  // bytes.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  spec.attribute("oiio:ColorSpace", options.space == WorkingSpace::acescg ? "ACEScg" : "linear");
  const WorkingSpaceInfo& space = info(options.space);
  std::array<float, 8> primaries{};
  std::transform(space.chromaticities.begin(), space.chromaticities.end(), primaries.begin(),
                 [](double v) { return static_cast<float>(v); });
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), primaries.data());
  spec.attribute("colorInteropID", space.public_name);
  const auto matrix = [&](const char* name, const std::optional<std::array<float, 16>>& values) {
    if (values) spec.attribute(name, OIIO::TypeDesc::TypeMatrix, values->data());
  };
  matrix("worldToCamera", options.world_to_camera);
  matrix("worldToNDC", options.world_to_ndc);
  return spec;
}

ExrOutput::ExrOutput(const std::filesystem::path& path, const std::filesystem::path& temporary,
                     const std::vector<OIIO::ImageSpec>& parts)
    : path_(path),
      temporary_(temporary),
      parts_(parts),
      file_(std::fopen(temporary.c_str(), "wb"), std::fclose),
      io_(file_.get(), OIIO::Filesystem::IOProxy::Write) {
  check(file_ != nullptr);
  output_ = OIIO::ImageOutput::create(temporary.string());  // By its extension.
  check(output_ != nullptr && output_->set_ioproxy(&io_));
  check(parts.size() == 1
            ? output_->open(temporary.string(), parts[0])
            : output_->open(temporary.string(), static_cast<int>(parts.size()), parts.data()));
}

void ExrOutput::begin(size_t part) {
  if (part > 0)
    check(output_->open(temporary_.string(), parts_[part], OIIO::ImageOutput::AppendSubimage));
}

void ExrOutput::close() {
  check(output_->close());
  // Only the error flag reports an earlier failed flush.
  const bool whole = std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0;
  check(std::fclose(file_.release()) == 0 && whole);
}

void ExrOutput::check(bool done) const {
  if (done) return;
  if (output_)
    (void)output_->geterror();  // Otherwise OpenImageIO prints it at exit.
  else
    (void)OIIO::geterror();
  const int fault = errno;  // May come from something else; only these errors result from writing.
  const bool system = fault == ENOSPC || fault == EFBIG || fault == EDQUOT || fault == EIO ||
                      fault == EACCES || fault == EROFS || fault == ENOMEM;
  throw Error(ErrorCode::io,
              fmt::format("cannot write picture '{}': {}", path_.string(),
                          system ? std::strerror(fault) : "the EXR writer refused it"));
}

namespace {

bool is_full(const std::string& channel, const ExrOptions& options) {
  return !options.half ||
         std::any_of(options.full_channels.begin(), options.full_channels.end(),
                     [&](const std::string& layer) { return in_layer(channel, layer); });
}

/// The channels of a part; those stored as half are clamped to its range.
std::vector<float> pixels_of(const Image& image, const PartChannels& part,
                             const ExrOptions& options) {
  std::vector<float> out(image.pixel_count() * part.count);
  for (size_t c = 0; c < part.count; ++c) {
    const bool full = is_full(image.channels[part.from + c], options);
    for (size_t p = 0; p < image.pixel_count(); ++p) {
      const float v = image.pixels[p * image.channels.size() + part.from + c];
      out[p * part.count + c] = full || !std::isfinite(v) ? v : std::clamp(v, -65504.0f, 65504.0f);
    }
  }
  return out;
}

}  // namespace

namespace {

/// The content of one part of a file.
struct FilePart {
  const ExrView* view;
  PartChannels channels;
  OIIO::ImageSpec spec;
};

/// Adds the parts of one view; with several views, the parts have a view attribute, and their names
/// begin with it.
void add_parts(const ExrView& view, std::vector<FilePart>& all) {
  const Image& image = view.image;
  const ExrOptions& options = view.options;
  for (const PartChannels& part : parts_of(image.channels, options.parts)) {
    OIIO::ImageSpec spec = exr_spec(image.width, image.height, options);
    spec.nchannels = static_cast<int>(part.count);
    spec.channelnames.assign(
        image.channels.begin() + static_cast<std::ptrdiff_t>(part.from),
        image.channels.begin() + static_cast<std::ptrdiff_t>(part.from + part.count));
    const auto place = [&](const char* channel) {
      const auto found =
          std::find(spec.channelnames.begin(), spec.channelnames.end(), std::string(channel));
      return found == spec.channelnames.end() ? -1
                                              : static_cast<int>(found - spec.channelnames.begin());
    };
    spec.alpha_channel = place("A"), spec.z_channel = place("Z");
    if (!view.name.empty()) spec.attribute("view", view.name);
    const std::string dot = view.name.empty() || part.name.empty() ? "" : ".";
    if (const std::string name = view.name + dot + part.name; !name.empty())
      spec.attribute("oiio:subimagename", name);
    for (const auto& [name, text] : options.metadata) {
      // A list of names accompanies its channels; everything else goes to the first part.
      const bool matte = name.rfind("cryptomatte/", 0) == 0;
      if (!options.parts || (matte ? part.name.rfind("Crypto", 0) == 0 : part.from == 0))
        spec.attribute(name, text);
    }
    bool mixed = false;
    for (const std::string& channel : spec.channelnames) {
      spec.channelformats.push_back(is_full(channel, options) ? OIIO::TypeDesc::FLOAT
                                                              : OIIO::TypeDesc::HALF);
      mixed |= spec.channelformats.back() != spec.channelformats.front();
    }
    spec.format = spec.channelformats.front();
    if (!mixed) spec.channelformats.clear();
    all.push_back({&view, part, std::move(spec)});
  }
}

}  // namespace

void write_exr(const std::filesystem::path& path, const std::filesystem::path& temporary,
               const std::vector<ExrView>& views) {
  std::vector<FilePart> parts;
  for (const ExrView& view : views) add_parts(view, parts);
  std::vector<OIIO::ImageSpec> specs;
  for (const FilePart& part : parts) specs.push_back(part.spec);
  ExrOutput output(path, temporary, specs);
  for (size_t i = 0; i < parts.size(); ++i) {
    output.begin(i);
    const ExrView& view = *parts[i].view;
    const std::vector<float> pixels = pixels_of(view.image, parts[i].channels, view.options);
    output.check(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
  }
  output.close();
}

}  // namespace vug::image::oiio

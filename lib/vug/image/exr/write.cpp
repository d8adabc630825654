// SPDX-License-Identifier: Apache-2.0
// Writing of flat EXR files with OpenEXR: parts, channels and texts.
#include <vug/base/parallel.h>
#include <vug/image/exr/exr_file.h>
#include <vug/image/exr/header.h>
#include <vug/image/exr/write.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescriptionAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <algorithm>
#include <cmath>

namespace vug::image::exr {
namespace {

/// `count` channels, starting at `from`, of one part of a file.
struct ChannelRange {
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

std::vector<ChannelRange> parts_of(const std::vector<std::string>& channels, bool split) {
  std::vector<ChannelRange> parts;
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

bool is_full(const std::string& channel, const ExrOptions& options) {
  return !options.half ||
         std::any_of(options.full_channels.begin(), options.full_channels.end(),
                     [&](const std::string& layer) { return in_layer(channel, layer); });
}

/// The content of one part of a file.
struct FilePart {
  const ExrView* view;
  ChannelRange channels;
  Imf::Header header;
};

constexpr unsigned kTile = 64;

Imf::Header file_part_header(const ExrView& view, const ChannelRange& part) {
  const ExrOptions& options = view.options;
  Imf::Header header = header_of(view.image.width, view.image.height, options, view.name);
  if (options.tiles) header.setTileDescription({kTile, kTile, Imf::ONE_LEVEL});
  const std::string dot = view.name.empty() || part.name.empty() ? "" : ".";
  if (const std::string name = view.name + dot + part.name; !name.empty()) header.setName(name);
  for (const auto& [name, text] : options.metadata) {
    // A list of names accompanies its channels; everything else goes to the first part.
    const bool matte = name.rfind("cryptomatte/", 0) == 0;
    if (!options.parts || (matte ? part.name.rfind("Crypto", 0) == 0 : part.from == 0))
      header.insert(name, Imf::StringAttribute(text));
  }
  for (size_t c = part.from; c < part.from + part.count; ++c) {
    const std::string& channel = view.image.channels[c];
    header.channels().insert(channel,
                             Imf::Channel(is_full(channel, options) ? Imf::FLOAT : Imf::HALF));
  }
  return header;
}

/// One channel as stored in the file; those stored as half are clamped to its range.
template <class Stored>
std::vector<Stored> plane_of(const Image& image, size_t channel) {
  std::vector<Stored> out(image.pixel_count());
  parallel_for(
      out.size(),
      [&](size_t p) {
        const float v = image.pixels[p * image.channels.size() + channel];
        if constexpr (std::is_same_v<Stored, float>)
          out[p] = v;
        else
          out[p] = half(std::isfinite(v) ? std::clamp(v, -65504.0f, 65504.0f) : v);
      },
      4096);
  return out;
}

/// The pixels of a part, a plane for each channel.
struct Planes {
  std::vector<std::vector<half>> halves;
  std::vector<std::vector<float>> floats;
  Imf::FrameBuffer buffer;
};

template <class Stored>
void add_plane(Imf::FrameBuffer& buffer, const std::string& name, const FilePart& part,
               std::vector<Stored>& plane) {
  const Imath::Box2i& window = part.header.dataWindow();
  buffer.insert(name, Imf::Slice::Make(std::is_same_v<Stored, half> ? Imf::HALF : Imf::FLOAT,
                                       plane.data(), window));
}

Planes planes_of(const FilePart& part) {
  const Image& image = part.view->image;
  Planes out;
  for (size_t c = part.channels.from; c < part.channels.from + part.channels.count; ++c) {
    const std::string& name = image.channels[c];
    if (is_full(name, part.view->options))
      add_plane(out.buffer, name, part, out.floats.emplace_back(plane_of<float>(image, c)));
    else
      add_plane(out.buffer, name, part, out.halves.emplace_back(plane_of<half>(image, c)));
  }
  return out;
}

/// Writes the pixels of a part to a file of its own or to a part of a larger file: scan lines to an
/// Imf::OutputFile or Imf::OutputPart, tiles to their tiled counterparts.
template <class Output>
void write_lines(Output&& output, const FilePart& part) {
  const Planes planes = planes_of(part);
  output.setFrameBuffer(planes.buffer);
  output.writePixels(part.view->image.height);
}

template <class Output>
void write_tiles(Output&& output, const FilePart& part) {
  const Planes planes = planes_of(part);
  output.setFrameBuffer(planes.buffer);
  output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
}

/// A file with one part, which readers of EXR 1 know as well.
void write_single(Imf::OStream& stream, const FilePart& part) {
  if (part.view->options.tiles)
    write_tiles(Imf::TiledOutputFile(stream, part.header), part);
  else
    write_lines(Imf::OutputFile(stream, part.header), part);
}

void write_multiple(Imf::OStream& stream, const std::vector<FilePart>& parts) {
  std::vector<Imf::Header> headers;
  for (const FilePart& part : parts) {
    headers.push_back(part.header);
    headers.back().setType(part.view->options.tiles ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
  }
  Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
  for (size_t i = 0; i < parts.size(); ++i) {
    const int index = static_cast<int>(i);
    if (parts[i].view->options.tiles)
      write_tiles(Imf::TiledOutputPart(file, index), parts[i]);
    else
      write_lines(Imf::OutputPart(file, index), parts[i]);
  }
}

}  // namespace

void write_flat(const std::filesystem::path& path, const std::filesystem::path& temporary,
                const std::vector<ExrView>& views) {
  std::vector<FilePart> parts;
  for (const ExrView& view : views)
    for (const ChannelRange& channels : parts_of(view.image.channels, view.options.parts))
      parts.push_back({&view, channels, file_part_header(view, channels)});
  write_file(path, temporary, [&](Imf::OStream& stream) {
    if (parts.size() == 1)
      write_single(stream, parts[0]);
    else
      write_multiple(stream, parts);
  });
}

}  // namespace vug::image::exr

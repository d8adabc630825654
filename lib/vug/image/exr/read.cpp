// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/image/exr/channel_order.h>
#include <vug/image/exr/read.h>
#include <vug/image/exr/threads.h>
#include <vug/image/part_channels.h>
#include <vug/image/read_error.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTestFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace vug::image::exr {
namespace {

bool is_plain(const Imf::Header& header) {
  if (header.hasType() && Imf::isDeepData(header.type())) return false;
  for (auto at = header.channels().begin(); at != header.channels().end(); ++at) {
    const Imf::Channel& channel = at.channel();
    if (channel.type == Imf::UINT || channel.xSampling != 1 || channel.ySampling != 1) return false;
  }
  return header.channels().begin() != header.channels().end();
}

/// An open file and its parts with the window of the first, up to the first other part.
struct Input {
  std::unique_ptr<Imf::MultiPartInputFile> file;
  std::vector<PartChannels> parts;

  const Imf::Header& header(size_t part) const { return file->header(static_cast<int>(part)); }
  int width() const { return header(0).dataWindow().max.x - header(0).dataWindow().min.x + 1; }
  int height() const { return header(0).dataWindow().max.y - header(0).dataWindow().min.y + 1; }
};

PartChannels part_channels(const Imf::Header& header) {
  PartChannels out;
  if (header.hasName()) out.name = header.name();
  if (header.hasView()) out.view = header.view();
  for (auto at = header.channels().begin(); at != header.channels().end(); ++at)
    out.channels.emplace_back(at.name());
  sort_channels(out.channels);
  return out;
}

std::optional<Input> open_flat(const std::filesystem::path& path) {
  if (extension_of(path) != ".exr" || !Imf::isOpenExrFile(path.c_str())) return std::nullopt;
  start_threads();
  Input input;
  try {
    input.file = std::make_unique<Imf::MultiPartInputFile>(path.c_str());
  } catch (const std::exception&) {
    throw unreadable_beginning(path, ".exr");
  }
  for (int part = 0; part < input.file->parts(); ++part) {
    const Imf::Header& header = input.file->header(part);
    if (part > 0 && header.dataWindow() != input.header(0).dataWindow()) break;
    if (!is_plain(header)) return std::nullopt;
    input.parts.push_back(part_channels(header));
  }
  require_reasonable_size(path, input.width(), input.height(), total_channels(input.parts));
  return input;
}

void read_channels(Imf::MultiPartInputFile& file, int part, const PartChannels& channels,
                   float* first, size_t stride) {
  Imf::InputPart input(file, part);
  const Imath::Box2i& window = input.header().dataWindow();
  Imf::FrameBuffer buffer;
  for (size_t c = 0; c < channels.channels.size(); ++c)
    buffer.insert(channels.channels[c],
                  Imf::Slice::Make(Imf::FLOAT, first + c, window, stride * sizeof(float)));
  input.setFrameBuffer(buffer);
  input.readPixels(window.min.y, window.max.y);
}

const char* format_of(const Imf::Header& header, const std::string& channel) {
  return header.channels()[channel].type == Imf::HALF ? "half" : "float";
}

void add_texts(const Imf::Header& header, Metadata& out) {
  for (auto at = header.begin(); at != header.end(); ++at)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&at.attribute())) {
      std::pair<std::string, std::string> entry(at.name(), text->value());
      if (std::find(out.begin(), out.end(), entry) == out.end()) out.push_back(std::move(entry));
    }
}

Chromaticities primaries_of(const Imf::Header& header) {
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  return {c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
}

}  // namespace

std::optional<Image> read_flat(const std::filesystem::path& path) {
  const std::optional<Input> input = open_flat(path);
  if (!input) return std::nullopt;
  const std::vector<std::string> names = channel_names(input->parts);
  require_memory(4.0 * input->width() * input->height() * static_cast<double>(names.size()),
                 available_memory(), fmt::format("the picture '{}'", path.string()));
  Image image(input->width(), input->height(), names);
  size_t channel = 0;
  for (size_t part = 0; part < input->parts.size(); ++part) {
    try {
      read_channels(*input->file, static_cast<int>(part), input->parts[part],
                    &image.pixels[channel], names.size());
    } catch (const std::exception&) {
      throw unreadable_pixels(path);
    }
    channel += input->parts[part].channels.size();
  }
  return image;
}

std::optional<FileInfo> read_flat_info(const std::filesystem::path& path) {
  const std::optional<Input> input = open_flat(path);
  if (!input) return std::nullopt;
  const Imf::Header& first = input->header(0);
  FileInfo info;
  info.width = input->width();
  info.height = input->height();
  info.left = first.dataWindow().min.x - first.displayWindow().min.x;
  info.top = first.dataWindow().min.y - first.displayWindow().min.y;
  info.channels = channel_names(input->parts);
  for (size_t part = 0; part < input->parts.size(); ++part) {
    for (const std::string& channel : input->parts[part].channels)
      info.formats.emplace_back(format_of(input->header(part), channel));
    add_texts(input->header(part), info.metadata);
  }
  if (Imf::hasChromaticities(first)) info.chromaticities = primaries_of(first);
  return info;
}

}  // namespace vug::image::exr

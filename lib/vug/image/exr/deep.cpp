// SPDX-License-Identifier: Apache-2.0
// Writing of deep EXR files with OpenEXR.
#include <vug/image/exr/exr_file.h>
#include <vug/image/exr/header.h>
#include <vug/image/exr/write.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>

namespace vug::image::exr {
namespace {

struct DeepChannel {
  const char* name;
  float DeepSample::*value;
  bool colour;  ///< Colours and alpha can be stored as half.
};

constexpr std::array<DeepChannel, 6> kChannels = {{{"R", &DeepSample::r, true},
                                                   {"G", &DeepSample::g, true},
                                                   {"B", &DeepSample::b, true},
                                                   {"A", &DeepSample::alpha, true},
                                                   {"Z", &DeepSample::near, false},
                                                   {"ZBack", &DeepSample::far, false}}};

bool is_half(const DeepChannel& channel, const ExrOptions& options) {
  return channel.colour && options.half;
}

Imf::Header deep_header(const DeepView& view) {
  const ExrOptions& options = view.options;
  Imf::Header header = header_of(view.image.width, view.image.height, options, view.name);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  if (!view.name.empty()) header.setName(view.name);
  for (const auto& [name, text] : options.metadata) header.insert(name, Imf::StringAttribute(text));
  for (const DeepChannel& channel : kChannels)
    header.channels().insert(channel.name,
                             Imf::Channel(is_half(channel, options) ? Imf::HALF : Imf::FLOAT));
  return header;
}

/// The samples of all pixels of one channel, and where those of each pixel begin.
template <class Stored>
struct DeepPlane {
  std::vector<Stored> samples;
  std::vector<const char*> pixels;

  DeepPlane(const DeepImage& deep, size_t count, float DeepSample::*value) {
    samples.reserve(count);
    pixels.reserve(deep.pixels.size());
    for (const std::vector<DeepSample>& pixel : deep.pixels) {
      pixels.push_back(reinterpret_cast<const char*>(samples.data() + samples.size()));
      for (const DeepSample& sample : pixel) samples.push_back(stored(sample.*value));
    }
  }

 private:
  static Stored stored(float v) {
    if constexpr (std::is_same_v<Stored, float>)
      return v;
    else
      return half(std::clamp(v, -65504.0f, 65504.0f));
  }
};

/// The address that OpenEXR expects for the pixel (0, 0), which may lie outside of the window.
template <class Element>
char* base_of(const std::vector<Element>& pixels, const Imath::Box2i& window) {
  const auto row = static_cast<std::ptrdiff_t>(window.max.x - window.min.x + 1);
  const std::ptrdiff_t first = window.min.x + window.min.y * row;
  return const_cast<char*>(reinterpret_cast<const char*>(pixels.data())) -
         first * static_cast<std::ptrdiff_t>(sizeof(Element));
}

template <class Stored>
void add_deep_plane(Imf::DeepFrameBuffer& buffer, const char* name, const DeepPlane<Stored>& plane,
                    const Imath::Box2i& window) {
  const auto row = static_cast<size_t>(window.max.x - window.min.x + 1);
  buffer.insert(name, Imf::DeepSlice(std::is_same_v<Stored, half> ? Imf::HALF : Imf::FLOAT,
                                     base_of(plane.pixels, window), sizeof(char*),
                                     sizeof(char*) * row, sizeof(Stored)));
}

void write_deep_part(Imf::MultiPartOutputFile& file, int index, const DeepView& view,
                     const Imath::Box2i& window) {
  const DeepImage& deep = view.image;
  std::vector<unsigned> counts;
  size_t total = 0;
  for (const std::vector<DeepSample>& pixel : deep.pixels) {
    counts.push_back(static_cast<unsigned>(pixel.size()));
    total += pixel.size();
  }
  Imf::DeepFrameBuffer buffer;
  buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, base_of(counts, window), sizeof(unsigned),
                                           sizeof(unsigned) * static_cast<size_t>(deep.width)));
  std::vector<DeepPlane<half>> halves;
  std::vector<DeepPlane<float>> floats;
  halves.reserve(kChannels.size()), floats.reserve(kChannels.size());
  for (const DeepChannel& channel : kChannels)
    if (is_half(channel, view.options))
      add_deep_plane(buffer, channel.name, halves.emplace_back(deep, total, channel.value), window);
    else
      add_deep_plane(buffer, channel.name, floats.emplace_back(deep, total, channel.value), window);
  Imf::DeepScanLineOutputPart output(file, index);
  output.setFrameBuffer(buffer);
  output.writePixels(deep.height);
}

}  // namespace

void write_deep(const std::filesystem::path& path, const std::filesystem::path& temporary,
                const std::vector<DeepView>& views) {
  std::vector<Imf::Header> headers;
  for (const DeepView& view : views) headers.push_back(deep_header(view));
  write_file(path, temporary, [&](Imf::OStream& stream) {
    Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
    for (size_t i = 0; i < views.size(); ++i)
      write_deep_part(file, static_cast<int>(i), views[i], headers[i].dataWindow());
  });
}

}  // namespace vug::image::exr

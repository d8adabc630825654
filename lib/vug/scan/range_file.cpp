// SPDX-License-Identifier: Apache-2.0
// EXR files of range images.
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/scan/range_image.h>

#include <charconv>
#include <cmath>
#include <sstream>

namespace vug::scan {
namespace {

constexpr const char* kPixel = "vug:pixel";  ///< Metres.
constexpr const char* kFrame = "vug:frame";  ///< Origin, x, y and z: twelve numbers.

std::string frame_text(const PlaneFrame& frame) {
  std::string out;
  for (const Vec3d& v : {frame.origin, frame.x, frame.y, frame.z})
    out += fmt::format("{}{} {} {}", out.empty() ? "" : " ", v.x, v.y, v.z);
  return out;
}

std::optional<PlaneFrame> parse_frame(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  PlaneFrame frame;
  for (Vec3d* v : {&frame.origin, &frame.x, &frame.y, &frame.z}) in >> v->x >> v->y >> v->z;
  return in ? std::optional(frame) : std::nullopt;
}

}  // namespace

image::Image to_image(const RangeImage& range) {
  image::Image out(range.width, range.height, {"depth", "count"});
  for (size_t p = 0; p < range.pixel_count(); ++p) {
    out.pixels[2 * p] = range.depth[p];
    out.pixels[2 * p + 1] = range.count[p];
  }
  return out;
}

image::Metadata range_metadata(const RangeImage& range) {
  image::Metadata out = pixel_metadata(range.pixel);
  out.emplace_back(kFrame, frame_text(range.frame));
  return out;
}

image::Metadata pixel_metadata(double pixel) { return {{kPixel, fmt::format("{}", pixel)}}; }

double pixel_from_metadata(const image::Metadata& metadata) {
  for (const auto& [name, text] : metadata) {
    if (name != kPixel) continue;
    double pixel = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), pixel);
    if (fault == std::errc() && pixel > 0 && std::isfinite(pixel)) return pixel;
    throw Error(ErrorCode::bad_input, fmt::format("invalid pixel size '{}'", text));
  }
  return 0;
}

void write_range(const std::filesystem::path& exr, const RangeImage& range) {
  image::ExrOptions options;
  options.metadata = range_metadata(range);
  image::write_exr(exr, to_image(range), options);
}

RangeImage read_range(const std::filesystem::path& exr, double pixel, uint64_t memory) {
  const image::FileInfo info = image::read_info(exr);
  // The file's channels as floats, then depth and count.
  require_memory(
      1.0 * info.width * info.height *
          (static_cast<double>(info.channels.size() * sizeof(float)) + sizeof(float) +
           sizeof(uint16_t)),
      memory,
      fmt::format("reading {} x {} pixels of {}", info.width, info.height, exr.filename().string()),
      "use a range image with larger pixels");
  const image::Image picture = image::read(exr);
  const int named = picture.find_channel("depth");
  const int depth = named >= 0 ? named : picture.find_channel("Z");
  if (depth < 0)
    throw Error(ErrorCode::bad_input, fmt::format("'{}' has no depth channel", exr.string()), {},
                "a range image needs a channel 'depth' or 'Z', in metres");
  RangeImage out;
  out.width = picture.width, out.height = picture.height;
  const double given = pixel > 0 ? pixel : pixel_from_metadata(info.metadata);
  out.pixel = given > 0 ? given : 0.01;
  for (const auto& [name, text] : info.metadata)
    if (name == kFrame) out.frame = parse_frame(text).value_or(PlaneFrame{});
  out.depth.reserve(picture.pixels.size() / picture.channels.size());
  out.count.reserve(out.depth.capacity());
  const int count = picture.find_channel("count");
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const float d = picture.at(x, y, static_cast<size_t>(depth));
      const float n = count < 0 ? 0 : picture.at(x, y, static_cast<size_t>(count));
      out.depth.push_back(std::isfinite(d) ? d : std::numeric_limits<float>::quiet_NaN());
      const bool known = count >= 0 && n >= 0 && n <= UINT16_MAX;
      out.count.push_back(known ? static_cast<uint16_t>(n) : std::isfinite(d) ? 1 : 0);
    }
  return out;
}

}  // namespace vug::scan

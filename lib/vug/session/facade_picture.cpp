// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/image/io.h>
#include <vug/scan/mask.h>
#include <vug/session/facade_picture.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vug::session {
namespace {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why,
                         const std::string& hint = "") {
  throw Error(ErrorCode::bad_input, fmt::format("'{}' {}", file.string(), why), {}, hint);
}

/// The most frequent value, in bins of one centimetre; values in metres.
float most_frequent(const std::vector<float>& values) {
  std::vector<long> bins;
  for (const float v : values)
    if (std::isfinite(v)) bins.push_back(std::lround(100 * v));
  std::sort(bins.begin(), bins.end());
  long best = 0;
  size_t most = 0;
  for (size_t i = 0; i < bins.size();) {
    const size_t begin = i;
    while (i < bins.size() && bins[i] == bins[begin]) ++i;
    if (i - begin > most) most = i - begin, best = bins[begin];
  }
  return static_cast<float>(static_cast<double>(best) / 100);
}

/// Depth behind the plane in metres, from either channel; nothing without one.
std::optional<image::Image> depth_of(const std::filesystem::path& file, const image::Image& whole) {
  const bool before = whole.find_channel("depth") >= 0;
  if (!before && whole.find_channel("Z") < 0) return std::nullopt;
  image::Image depth = whole.select({before ? "depth" : "Z"});
  constexpr float kSky = 1e6F;  // metres
  for (float& v : depth.pixels)
    if (!(std::abs(v) < kSky)) v = kHole;
  if (std::none_of(depth.pixels.begin(), depth.pixels.end(), [](float v) { return v == v; }))
    refuse(file, "has no depth in any pixel");
  const float wall = before ? 0 : most_frequent(depth.pixels);
  for (float& v : depth.pixels) v = before ? -v : v - wall;
  return depth;
}

/// R, G, B with finite values in all pixels; nothing for pictures of other data, such as depths.
std::optional<image::Image> to_rgb(const std::filesystem::path& file, const image::FileInfo& info,
                                   const image::Image& whole) {
  const bool grey = whole.channels.size() <= 2 && whole.find_channel("depth") != 0 &&
                    whole.find_channel("Z") != 0;
  if (whole.find_channel("R") < 0 && !grey) return std::nullopt;
  image::Image out = fit::to_rgb(whole, info);
  const auto finite = [](float v) { return std::isfinite(v); };
  if (std::none_of(out.pixels.begin(), out.pixels.end(), finite))
    refuse(file, "has no valid pixel");
  for (float& v : out.pixels) v = finite(v) ? v : 0;
  return out;
}

/// Computes each pixel from its value and the values of its 3x3 neighbourhood, in no order.
template <class Of>
image::Image filter_3x3(const image::Image& depth, const Of& of) {
  image::Image out = depth;
  std::array<float, 9> near{};
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      size_t count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(depth.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(depth.width - 1, x + 1); ++u)
          near[count++] = depth.at(u, v);
      out.at(x, y) =
          of(depth.at(x, y), near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count));
    }
  return out;
}

/// Sharpens depth steps: a mixed pixel takes the closer of the minimum and the maximum of its
/// neighbourhood (toggle mapping, cite kramer1975).
image::Image sharpen_steps(const image::Image& depth) {
  constexpr float kStep = 0.05F;  // metres; smaller steps are relief or noise
  return filter_3x3(depth, [&](float own, auto begin, auto end) {
    if (!std::isfinite(own)) return own;
    float least = own, most = own;
    for (auto at = begin; at != end; ++at)
      if (std::isfinite(*at)) least = std::min(least, *at), most = std::max(most, *at);
    if (most - least < kStep) return own;
    return own - least < most - own ? least : most;
  });
}

/// 3x3 median filter; holes count as deeper than all other values.
image::Image median_filter(const image::Image& depth) {
  constexpr float kDeepest = std::numeric_limits<float>::infinity();
  return filter_3x3(depth, [&](float, auto begin, auto end) {
    for (auto at = begin; at != end; ++at)
      if (!std::isfinite(*at)) *at = kDeepest;
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    return *middle == kDeepest ? kHole : *middle;
  });
}

void set_depth(FacadePicture& picture, const image::Image& depth) {
  picture.depth =
      median_filter(sharpen_steps(fit::downsampled(depth, {picture.width, picture.height})));
  scan::Mask solid(picture.width, picture.height);
  for (size_t i = 0; i < solid.on.size(); ++i)
    solid.on[i] = std::isfinite(picture.depth->pixels[i]);
  picture.outside = scan::outside_of(solid).on;
}

void require_pixels(int width, int height, const std::string& what) {
  if (std::min(width, height) >= kMinPixels) return;
  throw Error(
      ErrorCode::bad_input,
      fmt::format("{} has {} x {} pixels, too few to recognise windows", what, width, height), {},
      fmt::format("{} per side are the minimum", kMinPixels));
}

bool of_one_colour(const image::Image& picture) {
  const size_t channels = picture.channels.size();
  return std::equal(picture.pixels.begin() + static_cast<std::ptrdiff_t>(channels),
                    picture.pixels.end(), picture.pixels.begin());
}

/// The part of a picture in the box.
image::Image cropped(const image::Image& picture, const scan::PixelBox& box) {
  image::Image out(box.x1 - box.x0, box.y1 - box.y0, picture.channels);
  const size_t row = static_cast<size_t>(out.width) * out.channels.size();
  for (int y = 0; y < out.height; ++y)
    std::copy_n(&picture.pixels[picture.index(box.x0, box.y0 + y)], row,
                &out.pixels[out.index(0, y)]);
  return out;
}

/// The box of the crop in pixels of a picture of the same view with another resolution.
scan::PixelBox scaled(const scan::PixelBox& box, double across, double down) {
  const auto place = [](int at, double scale) { return static_cast<int>(std::lround(at * scale)); };
  return {place(box.x0, across), place(box.y0, down), place(box.x1, across), place(box.y1, down)};
}

/// The box that is used of the photo.
scan::PixelBox used_box(const std::filesystem::path& photo, const image::FileInfo& info,
                        const FacadePictureOptions& options) {
  const scan::PixelBox all{0, 0, info.width, info.height};
  const scan::PixelBox box = options.crop.value_or(all);
  if (box.x0 < 0 || box.y0 < 0 || box.x1 > all.x1 || box.y1 > all.y1)
    refuse(photo,
           fmt::format("has {} x {} pixels, and the crop ends at {},{}", all.x1, all.y1, box.x1,
                       box.y1),
           "crop to a part of the picture");
  require_pixels(box.x1 - box.x0, box.y1 - box.y0,
                 options.crop ? "the crop" : fmt::format("'{}'", photo.string()));
  return box;
}

}  // namespace

FacadePicture read_facade_picture(const std::filesystem::path& photo,
                                  const FacadePictureOptions& options) {
  const image::FileInfo info = image::read_info(photo);
  const scan::PixelBox box = used_box(photo, info, options);
  const image::Image whole = cropped(fit::read_with_limit(photo, info, options.max_memory), box);
  const fit::WorkingSize size = fit::working_size(whole.width, whole.height, options.limits);
  FacadePicture out;
  out.width = size.width, out.height = size.height;
  out.shape = static_cast<double>(whole.width) / whole.height;
  if (const auto colours = to_rgb(photo, info, whole))
    out.colours = fit::downsampled(*colours, size);
  std::optional<image::Image> depth;
  if (options.depth.empty()) {
    depth = depth_of(photo, whole);
    if (!depth && !out.colours)
      refuse(photo, "has neither colours nor a depth channel",
             "its channels are R, G, B, and depth or Z in metres");
  } else {
    const image::FileInfo beside = image::read_info(options.depth);
    const double across = static_cast<double>(beside.width) / info.width;
    const double down = static_cast<double>(beside.height) / info.height;
    const scan::PixelBox there = scaled(box, across, down);
    if (std::abs(across / down - 1) > 0.02 || there.x1 - there.x0 < out.width ||
        there.y1 - there.y0 < out.height)
      refuse(options.depth,
             fmt::format("is {} x {} pixels and the picture {} x {}", beside.width, beside.height,
                         info.width, info.height),
             "both must show the same rectangle of the wall");
    const image::Image other =
        cropped(fit::read_with_limit(options.depth, beside, options.max_memory), there);
    out.metres_wide = scan::pixel_from_metadata(beside.metadata) * other.width;
    depth = depth_of(options.depth, other);
    if (!depth)
      refuse(options.depth, "has no depth channel", "the channel is depth or Z, in metres");
  }
  if (depth)
    set_depth(out, *depth);
  else if (of_one_colour(*out.colours))
    refuse(photo, "has only one colour", "windows cannot be distinguished from walls");
  if (out.metres_wide == 0)
    out.metres_wide = scan::pixel_from_metadata(info.metadata) * whole.width;
  return out;
}

namespace {

image::Image depth_behind(const scan::RangeImage& range) {
  image::Image depth(range.width, range.height, {"depth"});
  for (size_t i = 0; i < depth.pixels.size(); ++i) depth.pixels[i] = -range.depth[i];
  return depth;
}

}  // namespace

FacadePicture facade_picture(const scan::RangeImage& range, const fit::WorkingLimits& limits) {
  require_pixels(range.width, range.height, "the range image");
  const fit::WorkingSize size = fit::working_size(range.width, range.height, limits);
  FacadePicture out;
  out.width = size.width, out.height = size.height;
  out.shape = range.metres_wide() / range.metres_high();
  out.metres_wide = range.metres_wide();
  set_depth(out, depth_behind(range));
  return out;
}

void add_depth(FacadePicture& picture, const scan::RangeImage& range) {
  const double shape = range.metres_wide() / range.metres_high();
  if (std::abs(shape / picture.shape - 1) > 0.05 || range.width < picture.width ||
      range.height < picture.height)
    throw Error(
        ErrorCode::bad_input,
        fmt::format(
            "the scan shows {:.2f} x {:.2f} m of the wall, whose aspect ratio differs from that of "
            "the picture",
            range.metres_wide(), range.metres_high()),
        {}, "cut the picture to the same rectangle, or rectify it");
  set_depth(picture, depth_behind(range));
  picture.shape = shape;
  picture.metres_wide = range.metres_wide();
}

}  // namespace vug::session

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/base/srgb.h>
#include <vug/fit/evidence/working_size.h>
#include <vug/image/io.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::fit {
namespace {

/// The range of pixels along one axis that overlap one target pixel, and their weights.
struct Span {
  int begin = 0;
  std::vector<double> shares;
};

std::vector<Span> sample_spans(int from, int to) {
  std::vector<Span> out(static_cast<size_t>(to));
  const double step = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double low = i * step, high = (i + 1) * step;
    Span& span = out[static_cast<size_t>(i)];
    span.begin = static_cast<int>(low);
    for (int at = span.begin; at < from && at < high; ++at)
      span.shares.push_back(std::min(high, at + 1.0) - std::max(low, static_cast<double>(at)));
  }
  return out;
}

}  // namespace

WorkingSize working_size(int width, int height, const WorkingLimits& limits) {
  const double scale =
      std::min({1.0, static_cast<double>(limits.height) / height,
                std::sqrt(static_cast<double>(limits.pixels) / (1.0 * width * height))});
  const auto scaled = [&](int size) {
    return std::max(1, std::min(size, static_cast<int>(std::floor(scale * size + 0.5))));
  };
  return {scaled(width), scaled(height)};
}

image::Image downsampled(const image::Image& picture, WorkingSize size) {
  if (size.width < 1 || size.height < 1 || size.width > picture.width ||
      size.height > picture.height)
    throw Error(ErrorCode::bad_input,
                fmt::format("cannot downsample {} x {} pixels to {} x {}", picture.width,
                            picture.height, size.width, size.height));
  if (size == WorkingSize{picture.width, picture.height}) return picture;
  image::Image out(size.width, size.height, picture.channels);
  const std::vector<Span> across = sample_spans(picture.width, size.width);
  const std::vector<Span> down = sample_spans(picture.height, size.height);
  parallel_for(static_cast<size_t>(size.height), [&](size_t row) {
    for (int x = 0; x < size.width; ++x)
      for (size_t c = 0; c < picture.channels.size(); ++c) {
        const Span &h = across[static_cast<size_t>(x)], &v = down[row];
        double sum = 0, known = 0, all = 0;
        for (size_t j = 0; j < v.shares.size(); ++j)
          for (size_t i = 0; i < h.shares.size(); ++i) {
            const double share = v.shares[j] * h.shares[i];
            const float value =
                picture.at(h.begin + static_cast<int>(i), v.begin + static_cast<int>(j), c);
            all += share;
            if (!std::isfinite(value)) continue;
            sum += share * value;
            known += share;
          }
        out.at(x, static_cast<int>(row), c) = 2 * known >= all
                                                  ? static_cast<float>(sum / known)
                                                  : std::numeric_limits<float>::quiet_NaN();
      }
  });
  return out;
}

std::vector<uint8_t> resampled(const std::vector<uint8_t>& marks, WorkingSize from,
                               WorkingSize to) {
  if (from.width < 1 || from.height < 1 || to.width < 1 || to.height < 1)
    throw Error(ErrorCode::bad_input, "a picture needs at least one pixel");
  std::vector<uint8_t> out;
  out.reserve(static_cast<size_t>(to.width) * static_cast<size_t>(to.height));
  const auto middle = [](int i, int many, int fewer) {
    return static_cast<size_t>((2 * static_cast<int64_t>(i) + 1) * many /
                               (2 * static_cast<int64_t>(fewer)));
  };
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x)
      out.push_back(marks[middle(y, from.height, to.height) * static_cast<size_t>(from.width) +
                          middle(x, from.width, to.width)]);
  return out;
}

double read_memory(int width, int height, size_t channels) {
  // As floats, both with the channels of the file and as R, G and B.
  return 1.0 * width * height * (static_cast<double>(channels) + 3) * sizeof(float);
}

image::Image read_with_limit(const std::filesystem::path& path, const image::FileInfo& info,
                             uint64_t max_memory) {
  require_memory(read_memory(info.width, info.height, info.channels.size()),
                 max_memory ? max_memory : available_memory(),
                 fmt::format("reading {} x {} pixels of {}", info.width, info.height,
                             path.filename().string()),
                 "use a smaller picture");
  return image::read(path, {.linear = true});
}

image::Image to_rgb(const image::Image& picture, const image::FileInfo& file) {
  if (picture.channels.size() > 2) return picture.select({"R", "G", "B"});
  // Channels named R are already converted to linear light on reading.
  const bool encoded = file.formats[0].rfind("uint", 0) == 0 && picture.channels[0] != "R";
  image::Image out(picture.width, picture.height, {"R", "G", "B"});
  for (size_t i = 0; i < out.pixels.size(); ++i) {
    const float value = picture.pixels[i / 3 * picture.channels.size()];
    out.pixels[i] = encoded ? static_cast<float>(srgb_decode(value)) : value;
  }
  return out;
}

image::Image read_photo(const std::filesystem::path& path, uint64_t max_memory) {
  const image::FileInfo info = image::read_info(path);
  return to_rgb(read_with_limit(path, info, max_memory), info);
}

}  // namespace vug::fit

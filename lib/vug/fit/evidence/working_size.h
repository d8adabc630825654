// Pictures made smaller before they are looked at: what tells windows from walls needs no more
// than a few pixels of each, and a scan of 100 megapixels shall cost no more than a snapshot.
#pragma once

#include <vug/image/io.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace vug::fit {

struct WorkingSize {
  int width = 0, height = 0;
  bool operator==(const WorkingSize&) const = default;
};

struct WorkingLimits {
  int height = 360;      ///< At most, in pixels,
  int pixels = 250'000;  ///< and this many of them in all.
};

/// The size, in the same proportions, that a picture of width x height pixels is looked at; its
/// own if it is within the limits. At least a pixel to each side.
WorkingSize working_size(int width, int height, const WorkingLimits& limits = {});

/// Means over the pixels that fall into each, weighted with their share of it. What is not finite
/// is left out; where it is more than half of the pixel, NaN.
/// Error(bad_input) for a size that is not positive or above the picture's.
image::Image downsampled(const image::Image& picture, WorkingSize size);

/// Classes, or other marks, of a picture of another size, larger or smaller: of the pixel in the
/// middle of each. Error(bad_input) for sizes that are not positive.
std::vector<uint8_t> resampled(const std::vector<uint8_t>& marks, WorkingSize from, WorkingSize to);

/// Bytes that reading a picture of that many pixels and channels takes, and making it smaller.
double read_memory(int width, int height, size_t channels);

/// image::read in linear light; `info` is the file's. Error(too_large), before the pixels are read,
/// where that and making it smaller takes more than `max_memory` bytes (0: what is available).
image::Image read_with_limit(const std::filesystem::path& path, const image::FileInfo& info,
                             uint64_t max_memory = 0);

/// Linear R, G and B; of a grey picture, of at most two channels, the same three times. `file` is
/// what it was read from. Error(bad_input) where there are no such channels.
image::Image to_rgb(const image::Image& picture, const image::FileInfo& file);

/// Both: a file's colours.
image::Image read_photo(const std::filesystem::path& path, uint64_t max_memory = 0);

}  // namespace vug::fit

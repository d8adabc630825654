// SPDX-License-Identifier: Apache-2.0
// Downsampling before analysis: a few pixels per window suffice, and a scan of 100 megapixels
// should cost no more than a snapshot.
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
  int height = 360;      ///< Maximum height in pixels.
  int pixels = 250'000;  ///< Maximum number of pixels.
};

/// The size at which a picture of width x height pixels is analysed: the same proportions, at least
/// one pixel per side; unchanged if within the limits.
WorkingSize working_size(int width, int height, const WorkingLimits& limits = {});

/// Area-weighted means over the pixels that fall into each target pixel. Non-finite values are
/// ignored; if they cover more than half of a target pixel, it becomes NaN. Error(bad_input) for a
/// size that is not positive or exceeds the picture's.
image::Image downsampled(const image::Image& picture, WorkingSize size);

/// Resamples classes or other marks, up or down, by the value at the centre of each target pixel.
/// Error(bad_input) for non-positive sizes.
std::vector<uint8_t> resampled(const std::vector<uint8_t>& marks, WorkingSize from, WorkingSize to);

/// Memory in bytes for reading and downsampling a picture with this number of pixels and channels.
double read_memory(int width, int height, size_t channels);

/// image::read in linear light; `info` describes the file. Error(too_large), before the pixels are
/// read, if reading and downsampling need more than `max_memory` bytes (0: the available memory).
image::Image read_with_limit(const std::filesystem::path& path, const image::FileInfo& info,
                             uint64_t max_memory = 0);

/// Linear R, G and B; a grey picture (at most two channels) is replicated. `file` describes the
/// source. Error(bad_input) if the channels are missing.
image::Image to_rgb(const image::Image& picture, const image::FileInfo& file);

/// Reads a photo and converts it with to_rgb.
image::Image read_photo(const std::filesystem::path& path, uint64_t max_memory = 0);

}  // namespace vug::fit

// SPDX-License-Identifier: Apache-2.0
// Range images: depths of a point cloud over a plane, in an orthographic view.
#pragma once

#include <vug/base/memory.h>
#include <vug/image/io.h>
#include <vug/scan/plane.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace vug::scan {

/// Row 0 is the top row, as in pictures. The origin of the frame is the lower left corner of the
/// image on the plane.
struct RangeImage {
  int width = 0;
  int height = 0;
  double pixel = 0;  ///< Side length of a pixel in metres.
  PlaneFrame frame;
  /// Metres in front of the plane, towards the scanner; NaN without a return: glass absorbs pulses
  /// and the sky returns none, so holes are evidence too.
  std::vector<float> depth;
  std::vector<uint16_t> count;  ///< Number of points in the pixel; 0 also for inpainted depths.

  size_t pixel_count() const { return depth.size(); }
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  /// Centre of a pixel on the plane: metres from the lower left corner, y up.
  Vec2d pixel_center(int x, int y) const { return {(x + 0.5) * pixel, (height - y - 0.5) * pixel}; }
  double metres_wide() const { return width * pixel; }
  double metres_high() const { return height * pixel; }
};

enum class DepthStatistic {
  median,   ///< Median of the pixel's points; for an even number the one nearer to the scanner.
  nearest,  ///< The point nearest to the scanner.
};

struct RangeOptions {
  double pixel = 0.01;  ///< Metres.
  DepthStatistic depth = DepthStatistic::median;
  double before = 0.5;  ///< Points further in front of the foremost wall are ignored, metres.
  double behind = 1.0;  ///< Points further behind the rearmost wall are ignored, metres.
  /// Pixels without points take the depth of the nearest pixel with points within this distance in
  /// metres; below 0: derived from the point spacing of the facade; 0: no inpainting.
  double inpaint_radius = -1;
  uint64_t memory = available_memory();  ///< Memory limit in bytes while the image is created.
};

/// The raster covers the largest connected group of points within three tolerances of the plane or
/// of a wall parallel to it, so that objects two metres next to them are excluded. Error(bad_input)
/// for options out of range, Error(too_large) before memory is allocated. The result does not
/// depend on the number of threads.
RangeImage range_image(const PointCloud& cloud, const PlaneFit& plane,
                       const RangeOptions& options = {});

/// Typical distance between neighbouring points on the plane in metres: half of the points lie in
/// regions that are at least this dense.
double spacing(const PointCloud& cloud, const PlaneFrame& frame, const RangeOptions& options = {});

/// Channels "depth" and "count"; write as EXR with 32 bits.
image::Image to_image(const RangeImage& range);
/// File metadata: the pixel size and the frame.
image::Metadata range_metadata(const RangeImage& range);
/// Metadata of the pixel size alone, in metres, and its inverse: 0 without metadata,
/// Error(bad_input) for an invalid length.
image::Metadata pixel_metadata(double pixel);
double pixel_from_metadata(const image::Metadata& metadata);
void write_range(const std::filesystem::path& exr, const RangeImage& range);
/// Reads a file of write_range, or any EXR with its channels and metadata. Other files provide the
/// channel "depth" or else "Z"; `pixel` is then the side length in metres, 1 cm by default.
/// Error(bad_input); Error(too_large), before the pixels are read, beyond `memory` bytes.
RangeImage read_range(const std::filesystem::path& exr, double pixel = 0,
                      uint64_t memory = available_memory());

}  // namespace vug::scan

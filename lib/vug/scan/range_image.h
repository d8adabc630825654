// A cloud seen square on: depths over a plane, pixel by pixel.
#pragma once

#include <vug/base/memory.h>
#include <vug/image/io.h>
#include <vug/scan/plane.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace vug::scan {

/// Row 0 is the top row, as in pictures. The frame's origin is the lower left corner of the image
/// on the plane.
struct RangeImage {
  int width = 0;
  int height = 0;
  double pixel = 0;  ///< Metres on a side.
  PlaneFrame frame;
  /// Metres before the plane, towards the scanner; NaN where nothing came back: glass and the sky
  /// swallow pulses, so holes are evidence too.
  std::vector<float> depth;
  std::vector<uint16_t> count;  ///< Points in the pixel; 0 also where `depth` is a neighbour's.

  size_t pixel_count() const { return depth.size(); }
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  /// The middle of a pixel on the plane: metres from the lower left corner, y up.
  Vec2d pixel_center(int x, int y) const { return {(x + 0.5) * pixel, (height - y - 0.5) * pixel}; }
  double metres_wide() const { return width * pixel; }
  double metres_high() const { return height * pixel; }
};

enum class DepthStatistic {
  median,   ///< Of the points of a pixel; of an even number the one nearer to the scanner.
  nearest,  ///< To the scanner.
};

struct RangeOptions {
  double pixel = 0.01;  ///< Metres.
  DepthStatistic depth = DepthStatistic::median;
  double before = 0.5;  ///< Points farther before the plane than this are left out, in metres.
  double behind = 1.0;  ///< Likewise behind it.
  /// Pixels without points take the depth of the nearest one with some, if that is no farther than
  /// this, in metres; below 0: as far as points of the facade are apart; 0: never.
  double inpaint_radius = -1;
  uint64_t memory = available_memory();  ///< Bytes the image may take while it is made.
};

/// The raster reaches as far as the points within three tolerances of the plane do that hang
/// together: what stands two metres beside them is no part of the facade. Error(bad_input) for
/// options out of range, Error(too_large) before memory is taken. The same for any number of
/// threads.
RangeImage range_image(const PointCloud& cloud, const PlaneFit& plane,
                       const RangeOptions& options = {});

/// How far apart neighbouring points of a surface on the plane are, in metres: a half of them stand
/// in places that are at least so dense.
double spacing(const PointCloud& cloud, const PlaneFrame& frame, const RangeOptions& options = {});

/// Channels "depth" and "count"; write as EXR with 32 bits.
image::Image to_image(const RangeImage& range);
/// What a file tells beside: the size of its pixels and the frame.
image::Metadata range_metadata(const RangeImage& range);
/// The same of the size of a pixel alone, in metres, and back: 0 where nothing tells, and
/// Error(bad_input) where it is no length.
image::Metadata pixel_metadata(double pixel);
double pixel_from_metadata(const image::Metadata& metadata);
void write_range(const std::filesystem::path& exr, const RangeImage& range);
/// What write_range wrote, or any EXR with its channels and metadata; of others the channel "depth"
/// or else "Z", with `pixel` metres on a side, 1 cm unless told. Error(bad_input);
/// Error(too_large), before the pixels are read, beyond `memory` bytes.
RangeImage read_range(const std::filesystem::path& exr, double pixel = 0,
                      uint64_t memory = available_memory());

}  // namespace vug::scan

// SPDX-License-Identifier: Apache-2.0
// The input of facade fitting: colours, and the depth behind the plane of the wall.
#pragma once

#include <vug/fit/evidence/working_size.h>
#include <vug/scan/mask.h>
#include <vug/scan/range_image.h>

#include <optional>

namespace vug::session {

/// A picture at its working resolution; see fit::working_size.
struct FacadePicture {
  int width = 0, height = 0;
  /// Exact aspect ratio (width / height) of the view; that of whole pixels only approximates it.
  double shape = 1;
  double metres_wide = 0;               ///< Width of the view in metres; 0: unknown.
  std::optional<image::Image> colours;  ///< R, G, B, linear.
  std::optional<image::Image> depth;    ///< One channel: metres behind the plane, NaN in holes.
  /// 1 for pixels left of, right of or above the facade: those in holes of the depth that reach the
  /// left, right or upper border of the picture. Empty without depth.
  std::vector<uint8_t> outside;
};

/// Minimum number of pixels per side at which windows are recognisable.
constexpr int kMinPixels = 16;

struct FacadePictureOptions {
  fit::WorkingLimits limits;
  std::filesystem::path depth;  ///< Depth file; empty: channels of the picture itself.
  /// The part of the picture that shows the facade, in its pixels; nothing: all of it.
  std::optional<scan::PixelBox> crop = std::nullopt;
  uint64_t max_memory = 0;  ///< Bytes; 0: the machine's free memory.
};

/// Reads the colours and the depth of a facade. The depth is a channel `depth` (metres in front of
/// the plane), or `Z` (metres from an orthographic camera), whose most frequent value is the wall.
/// The size follows from the pixel size in the header of the depth file, else of the photograph. A
/// crop applies to both files, which show the same view. Error(bad_input) for files that are not
/// pictures, that differ in aspect ratio, that have fewer than kMinPixels per side, no valid pixel,
/// or a single colour, and for a crop that exceeds the picture; Error(too_large) before they are
/// read.
FacadePicture read_facade_picture(const std::filesystem::path& photo,
                                  const FacadePictureOptions& options = {});

/// The picture of a laser scan, without a photograph.
FacadePicture facade_picture(const scan::RangeImage& range, const fit::WorkingLimits& limits = {});
/// Adds the depth and the size of a laser scan to a photograph of the same rectangle.
/// Error(bad_input) if their aspect ratios differ.
void add_depth(FacadePicture& picture, const scan::RangeImage& range);

}  // namespace vug::session

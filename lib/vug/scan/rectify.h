// SPDX-License-Identifier: Apache-2.0
// Perspective rectification of photos, and photos resampled onto range images.
#pragma once

#include <vug/base/memory.h>
#include <vug/image/warp.h>
#include <vug/scan/range_image.h>

namespace vug::scan {

using FourPoints = std::array<Vec2d, 4>;

/// The homography that maps `from` to `to`, computed in normalised coordinates [@hartley1997].
/// Error(bad_input) if three points of either set are collinear, or nearly so.
image::Homography homography(const FourPoints& from, const FourPoints& to);

struct RectifyOptions {
  /// Width and height of the rectangle spanned by the corners: metres, or any unit if only the
  /// ratio is known. Both 0: the ratio is estimated from the corners.
  double width = 0, height = 0;
  /// Pixel size in the same unit; 0: the finest resolution of the photo inside the corners.
  double pixel = 0;
  uint64_t memory = available_memory();  ///< Memory limit of the picture in bytes.
};

struct RectifiedPhoto {
  image::Image picture;
  double width = 0, height = 0;  ///< As in the options; without them the height is 1.
};

/// The region between four corners of a photo, which are pixels from its upper left corner, y down,
/// clockwise starting with the upper left one. Error(bad_input) unless the corners form a convex
/// quadrangle in this order, Error(too_large) before memory is allocated.
RectifiedPhoto rectify(const image::Image& photo, const FourPoints& corners,
                       const RectifyOptions& options = {});

/// Aspect ratio (width by height) of the rectangle with these corners, for a camera with square
/// pixels and its principal point at the photo's centre [@zhang2007whiteboard]; the ratio of the
/// side lengths if the sides are nearly parallel in the photo. Error(bad_input) as above.
double estimate_aspect(const FourPoints& corners, int photo_width, int photo_height);

/// The photo resampled to the pixels of a range image: its channels, then "depth" and "count".
/// Points in the photo are in pixels as above, those on the facade in metres from the range image's
/// lower left corner, y up. Same errors, and Error(too_large) beyond `memory` bytes.
image::Image overlay_photo(const RangeImage& range, const image::Image& photo,
                           const FourPoints& in_photo, const FourPoints& on_facade,
                           uint64_t memory = available_memory());
/// The overload for a photo that shows the same rectangle as the range image.
image::Image overlay_photo(const RangeImage& range, const image::Image& photo,
                           uint64_t memory = available_memory());

}  // namespace vug::scan

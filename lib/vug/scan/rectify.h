// Photos that were taken at a slant, made square; and photos laid over range images.
#pragma once

#include <vug/base/memory.h>
#include <vug/image/warp.h>
#include <vug/scan/range_image.h>

namespace vug::scan {

using FourPoints = std::array<Vec2d, 4>;

/// The only homography that takes the four points to those, of normalised coordinates
/// [@hartley1997]. Error(bad_input) where three of either lie on one line, or nearly.
image::Homography homography(const FourPoints& from, const FourPoints& to);

struct RectifyOptions {
  /// Width and height of what the corners span: metres, or any unit where only their ratio is
  /// known. Both 0: the ratio follows from the corners themselves.
  double width = 0, height = 0;
  double pixel = 0;  ///< In the same unit; 0: as fine as the photo is where it is finest.
  uint64_t memory = available_memory();  ///< Bytes the picture may take.
};

struct RectifiedPhoto {
  image::Image picture;
  double width = 0, height = 0;  ///< As in the options; without these, height is 1.
};

/// What lies between four corners of a photo: pixels from its upper left corner, y down; clockwise
/// from the upper left one. Error(bad_input) for corners that make no convex quadrangle in this
/// order, Error(too_large) before memory is taken.
RectifiedPhoto rectify(const image::Image& photo, const FourPoints& corners,
                       const RectifyOptions& options = {});

/// Width by height of the rectangle of which the corners are a view, by a camera of square pixels
/// that looked at the photo's middle [@zhang2007whiteboard]; where its sides are next to parallel
/// in the photo the ratio of their lengths. Error(bad_input) as above.
double estimate_aspect(const FourPoints& corners, int photo_width, int photo_height);

/// The photo in the pixels of a range image: its channels, then "depth" and "count". Places in the
/// photo are in pixels as above, those on the facade in metres from the range image's lower left
/// corner, y up. Same errors, and Error(too_large) beyond `memory` bytes.
image::Image overlay_photo(const RangeImage& range, const image::Image& photo,
                           const FourPoints& in_photo, const FourPoints& on_facade,
                           uint64_t memory = available_memory());
/// The same where photo and range image show the same.
image::Image overlay_photo(const RangeImage& range, const image::Image& photo,
                           uint64_t memory = available_memory());

}  // namespace vug::scan

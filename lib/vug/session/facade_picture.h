// What is to be read as a facade: its colours, and how far its parts lie behind the wall's plane.
#pragma once

#include <vug/fit/evidence/working_size.h>
#include <vug/scan/range_image.h>

#include <optional>

namespace vug::session {

/// At the size that it is looked at; see fit::working_size.
struct FacadePicture {
  int width = 0, height = 0;
  /// Width by height of what it shows, which whole pixels only come near to.
  double shape = 1;
  double metres_wide = 0;               ///< Of what it shows; 0: nothing tells.
  std::optional<image::Image> colours;  ///< R, G, B, linear.
  std::optional<image::Image> depth;    ///< One channel: metres behind the plane, NaN in holes.
  /// 1 for a pixel that lies beside the facade or above it: in a hole of the depth that reaches the
  /// picture's left, right or upper border. Empty without depth.
  std::vector<uint8_t> outside;
};

/// Fewer, to a side, show no windows.
constexpr int kMinPixels = 16;

struct FacadePictureOptions {
  fit::WorkingLimits limits;
  std::filesystem::path depth;  ///< A file of the depth; empty: layers of the picture itself.
  uint64_t max_memory = 0;      ///< Bytes; 0: what the machine has.
};

/// The depth is a layer `depth` (metres before the plane), or `Z` (metres from an orthographic
/// camera), of which the most frequent is the wall. How large it is follows where the header of the
/// depth's file, or else of the photo's, tells the size of a pixel (scan::told_pixel).
/// Error(bad_input) for files that are no pictures, of different shape, of fewer than kMinPixels
/// a side, without any pixel that counts, or of one colour alone; Error(too_large) before they are
/// read.
FacadePicture read_facade_picture(const std::filesystem::path& photo,
                                  const FacadePictureOptions& options = {});

/// Of what a scanner saw alone.
FacadePicture facade_picture(const scan::RangeImage& range, const fit::WorkingLimits& limits = {});
/// The depth of what a scanner saw, and its size, for a photo of the same rectangle.
/// Error(bad_input) where their shapes differ.
void add_depth(FacadePicture& picture, const scan::RangeImage& range);

}  // namespace vug::session

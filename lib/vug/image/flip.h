// FLIP: the difference an observer sees who flips between two pictures on a screen.
//   LDR: Andersson et al. 2020, HDR: Andersson et al. 2021 (docs/references.bib: andersson2020flip,
//   andersson2021flip).
#pragma once

#include <vug/image/planes.h>

#include <optional>

namespace vug::image {

struct FlipOptions {
  /// Pixels in a degree of sight: here those of a screen 0.7 m and 3840 pixels wide, seen from
  /// 0.7 m, as in the paper.
  double pixels_per_degree = 0.7 * 3840 / 0.7 * 3.14159265358979323846 / 180;
};

/// Differences in [0, 1], 0 where nothing is to be seen. Both pictures have channels R, G, B, the
/// linear light of a screen in [0, 1] (values outside are clipped, NaN is black), and one size.
Plane flip(const Image& reference, const Image& test, const FlipOptions& options = {});

/// From the shortest exposure to the longest, in stops.
struct ExposureRange {
  double start = 0;
  double stop = 0;

  /// As many as the range has stops, rounded up, but two at least.
  int count() const;
};

/// Exposures at which the brightest pixel, and at the other end the pixel of median luminance, come
/// out of the tone curve at 0.85 (andersson2021flip, section 4). Where more than half of the pixels
/// are black the median is that of the others: a cave is dark, and no exposure lights a black
/// pixel. Nothing for a picture without light.
std::optional<ExposureRange> exposure_range(const Image& reference);

/// The largest LDR-FLIP over the exposures, from scene-linear R, G, B through the ACES-like curve
/// of Narkowicz, as the paper does.
Plane flip_hdr(const Image& reference, const Image& test, const ExposureRange& range,
               const FlipOptions& options = {});

}  // namespace vug::image

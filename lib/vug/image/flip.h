// SPDX-License-Identifier: Apache-2.0
// FLIP: the difference that an observer perceives when alternating between two images.
//   LDR: Andersson et al. 2020, HDR: Andersson et al. 2021 (docs/references.bib: andersson2020flip,
//   andersson2021flip).
#pragma once

#include <vug/image/planes.h>

#include <optional>

namespace vug::image {

struct FlipOptions {
  /// Pixels per degree of visual angle; default as in the paper: a display 0.7 m and 3840 pixels
  /// wide, seen from 0.7 m.
  double pixels_per_degree = 0.7 * 3840 / 0.7 * 3.14159265358979323846 / 180;
};

/// Differences in [0, 1], 0 if nothing is visible. Both images have the same size and the channels
/// R, G, B with linear display light in [0, 1] (values outside are clipped, NaN is black).
Plane flip(const Image& reference, const Image& test, const FlipOptions& options = {});

/// From the shortest exposure to the longest, in stops.
struct ExposureRange {
  double start = 0;
  double stop = 0;

  /// Number of exposures: the range in stops, rounded up, at least 2.
  int count() const;
};

/// The exposures at which the brightest pixel and the pixel of median luminance reach 0.85 after
/// the tone curve (andersson2021flip, section 4). If more than half of the pixels are black, the
/// median is taken over the others, because caves are dark and no exposure lights a black pixel.
/// Returns nothing for an image without light.
std::optional<ExposureRange> exposure_range(const Image& reference);

/// The largest LDR-FLIP over all exposures, from scene-linear R, G, B through the ACES-like
/// curve of Narkowicz, as in the paper.
Plane flip_hdr(const Image& reference, const Image& test, const ExposureRange& range,
               const FlipOptions& options = {});

}  // namespace vug::image

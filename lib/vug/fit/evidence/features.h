// What a pixel and its surroundings look like, as numbers that a classifier can be trained on.
#pragma once

#include <vug/fit/evidence/box_filter.h>
#include <vug/image/image.h>

#include <cstddef>
#include <vector>

namespace vug::fit {

/// Planes of one number a pixel, row after row from the top.
struct Planes {
  int width = 0, height = 0;
  std::vector<Plane> planes;

  size_t count() const { return planes.size(); }
  size_t pixels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

/// CIE L*a*b* under D65 of linear Rec.709 R, G, B: three planes.
Planes to_lab(const image::Image& linear);

/// The planes less their means over boxes of a fifth of the height: what is left where one picture
/// has bright sky, dark shops and shadows.
Planes high_pass(const Planes& planes);

/// Colour, its means and deviations over boxes, edges, rows and columns of the picture, samples
/// from around, and the place in the picture. Boxes grow with the picture's height, so pictures of
/// one facade at two resolutions have like features.
Planes features(const image::Image& linear);
/// How many those are.
size_t feature_count();

/// The same of maps that an earlier classifier made, so that a later one sees what is around.
Planes context_features(const Planes& maps);
/// How many those are of each map.
size_t context_count();

}  // namespace vug::fit

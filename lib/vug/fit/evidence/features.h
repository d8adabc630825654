// SPDX-License-Identifier: Apache-2.0
// Features of a pixel and its surroundings for a classifier.
#pragma once

#include <vug/fit/evidence/box_filter.h>
#include <vug/image/image.h>

#include <cstddef>
#include <vector>

namespace vug::fit {

/// Image planes with one value per pixel, row by row from the top.
struct Planes {
  int width = 0, height = 0;
  std::vector<Plane> planes;

  size_t count() const { return planes.size(); }
  size_t pixels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

/// CIE L*a*b* under D65 of linear Rec.709 R, G, B: three planes.
Planes to_lab(const image::Image& linear);

/// The planes minus their box means over a fifth of the height, which removes bright skies, dark
/// shop fronts and shadows.
Planes high_pass(const Planes& planes);

/// Colour; its means and deviations over boxes; edges; row and column statistics; samples of the
/// surroundings; and the position in the picture. Boxes scale with the picture's height, so
/// pictures of one facade at two resolutions have comparable features.
Planes features(const image::Image& linear);
/// Number of planes returned by features().
size_t feature_count();

/// The corresponding features of the probability maps of an earlier classifier, which show a later
/// one the context of a pixel.
Planes context_features(const Planes& maps);
/// Number of context features per map.
size_t context_count();

}  // namespace vug::fit

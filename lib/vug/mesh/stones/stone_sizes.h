// SPDX-License-Identifier: Apache-2.0
// The sizes of the stones of a bed: a Rosin-Rammler distribution in classes.
#pragma once

#include <vector>

namespace vug::mesh {

/// The mass of the stones below a diameter d is the fraction 1 - exp(-(d / typical)^uniformity) of
/// all (Rosin and Rammler 1933, cite rosin1933laws), cut at both ends.
struct StoneSizes {
  double smallest = 0.02, largest = 0.2;  ///< Diameters, metres.
  double typical = 0.06;                  ///< 63 % of the mass is of smaller stones.
  double uniformity = 1.4;
};

/// Stones of about the same size.
struct StoneClass {
  double smallest = 0, largest = 0;  ///< Diameters, metres; within, their logarithm is uniform.
  double cover = 0;                  ///< Its fraction of the area that all stones cover in plan.

  /// The root of the mean square diameter.
  double mean_diameter() const;
};

/// Classes whose diameters grow by factors of up to 2^(1/4), the largest first; their covers sum to
/// 1. Error(bad_input) for sizes out of order.
std::vector<StoneClass> stone_classes(const StoneSizes& sizes);

/// The factors by which the classes are more frequent where the coarseness, 0 to 1, is `coarse`:
/// the current sorts stones, so that those of logarithmic size near `coarse` lie there, with the
/// standard deviation `spread` on the scale from the smallest (0) to the largest (1). The covers
/// times the factors sum to 1.
std::vector<double> sorting(const std::vector<StoneClass>& classes, double coarse, double spread);

}  // namespace vug::mesh

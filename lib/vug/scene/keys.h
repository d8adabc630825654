// SPDX-License-Identifier: Apache-2.0
// Interpolates between the keyframes of a parameter.
#pragma once

#include <vector>

namespace vug::scene {

enum class Ease {
  linear,
  smooth,  ///< Zero slope at the first and last key and at extrema; never overshoots.
  step     ///< Holds a key's value until the next key.
};

/// The value at `frame` of the curve through (frames[i], values[i]); constant before the first key
/// and after the last one. The frames are increasing and there is at least one. Smooth curves are
/// cubic with the slopes of Fritsch and Butland 1984, "A method for constructing local monotone
/// piecewise cubic interpolants" (fritsch1984monotone).
double interpolate_keys(const std::vector<double>& frames, const std::vector<double>& values,
                        Ease ease, double frame);

}  // namespace vug::scene

// Values between keys: how a parameter moves from frame to frame.
#pragma once

#include <vector>

namespace vug::scene {

enum class Ease {
  linear,
  smooth,  ///< Rests at the first and last key and at turning points, and never overshoots.
  step     ///< Keeps a key's value up to the next key.
};

/// The value at `frame` of the curve through (frames[i], values[i]); before the first key and after
/// the last it keeps still. The frames increase; there is at least one. Smooth curves are cubic
/// with the slopes of Fritsch and Butland 1984, "A method for constructing local monotone piecewise
/// cubic interpolants" (fritsch1984monotone).
double interpolate_keys(const std::vector<double>& frames, const std::vector<double>& values,
                        Ease ease, double frame);

}  // namespace vug::scene

// SPDX-License-Identifier: Apache-2.0
// Meanders along passages that a free stream cut: sine-generated curves (langbein1966meanders).
#pragma once

#include <vug/passages/curves/curve.h>

namespace vug::passages {

struct MeanderOptions {
  double sinuosity = 1;    ///< Length of the stream over that of the valley, 1 to 3.5; 1: straight.
  double wavelength = 11;  ///< In widths of the passage (leopold1964fluvial); above 0.
};

/// The angle omega in radians for which the curve with the direction omega cos(2 pi s / M) has the
/// sinuosity 1 / J0(omega).
double meander_amplitude(double sinuosity);

/// The curve with meanders to both sides, in horizontal planes, between consecutive fixed points.
/// The number of half waves between them is whole, so that fixed points stay; pieces shorter than
/// half a wave, and steeper than 45 degrees, are not changed, nor are legs of phreatic passages.
Curve meandered(const Curve& curve, const MeanderOptions& options);

}  // namespace vug::passages

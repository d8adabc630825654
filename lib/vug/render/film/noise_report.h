// SPDX-License-Identifier: Apache-2.0
// The noise of an unfinished picture, and what its limit still costs.
#pragma once

namespace vug::render {

struct NoiseReport {
  /// The root mean square over all pixels of their noise, as mark_converged measures it.
  double noise = 0;
  double samples = 0;  ///< Mean number of samples per pixel.
  /// The expected number of samples of all pixels until each tile has converged or has all its
  /// samples: the noise falls with the square root of the number of samples.
  double missing = 0;
};

}  // namespace vug::render

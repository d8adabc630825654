// SPDX-License-Identifier: Apache-2.0
// The powers of lamps under the condition that one of them, the key, dominates the subject.
#pragma once

#include <vug/scout/nnls.h>

#include <cstddef>
#include <vector>

namespace vug::scout {

struct KeyRatio {
  size_t part = 0;   ///< The row of the subject.
  double ratio = 1;  ///< Light of the key on the subject relative to that of all other lamps.
  double sky = 0;    ///< Light of the sky on the subject; if it is positive, the sky is the key.
};

/// fit_non_negative(columns, target), where column j is the light of lamp j on each part. The key
/// is the sky or else the lamp that lights the subject most. If the others give the subject more
/// than their share, the fit is repeated with an equation of large weight that holds the ratio
/// within 1 %.
NonNegativeFit fit_with_key(std::vector<std::vector<double>> columns, std::vector<double> target,
                            const KeyRatio& held);

}  // namespace vug::scout

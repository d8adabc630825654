// SPDX-License-Identifier: Apache-2.0
// The axes of all passages of a network: through the middle of the sections that were measured from
// the survey line, which is seldom in the middle of a passage.
#pragma once

#include <vug/passages/curves/chains.h>
#include <vug/passages/curves/curve.h>
#include <vug/passages/passages.h>

#include <vector>

namespace vug::passages {

/// One curve for each chain, smoothed and with meanders as the options say. A passage that meets
/// another one ends on its axis. Curves of fewer than two points have no passage.
std::vector<Curve> axes(const network::Network& network, const std::vector<Chain>& chains,
                        const PassageOptions& options);

}  // namespace vug::passages

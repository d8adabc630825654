// SPDX-License-Identifier: Apache-2.0
// Key points between which no water can flow.
#pragma once

#include <vug/karst/key_points.h>

namespace vug::karst {

/// Throws Error(bad_input) for key points outside the bounds or the solid of the rock, a sink below
/// all springs, a sink in the place of a spring, and names that cannot be those of stations.
void require_no_contradiction(const KeyPoints& keys, const Rock& rock);

}  // namespace vug::karst

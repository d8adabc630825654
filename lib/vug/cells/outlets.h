// SPDX-License-Identifier: Apache-2.0
// The cells at which running water leaves a surface.
#pragma once

#include <vug/cells/attributes.h>
#include <vug/cells/network.h>

#include <vector>

namespace vug::cells {

/// 1 for each outlet, else 0. Water leaves at
/// - the open edges of a mesh towards which the surface falls, and the edges of level sheets,
/// - the lowest points of overhangs, where drops fall,
/// - cells that are not active,
/// - the lowest cell of each connected piece that would have no other outlet: a closed basin seeps
///   away there instead of filling to its roof.
std::vector<uint8_t> find_outlets(const Network& network, const CellState* states);

}  // namespace vug::cells

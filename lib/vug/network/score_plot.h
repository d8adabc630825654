// SPDX-License-Identifier: Apache-2.0
// The drawing of a scored network among real caves.
#pragma once

#include <vug/network/score_report.h>

#include <string>

namespace vug::network {

/// An SVG with one row for each criterion: the range of real caves, their band from the 10 % to the
/// 90 % quantile (for passages: of the surveyed regions), the median, and the value of the cave.
/// Rows whose values span more than a factor of eight have logarithmic axes. Values beyond the axis
/// are triangles at its end. The sentences of advice follow. The same input gives the same bytes.
std::string score_svg(const ScoredNetwork& cave);

}  // namespace vug::network

// SPDX-License-Identifier: Apache-2.0
// The frames and sections at the points of a passage's axis, selected by the rules of the options.
#pragma once

#include <vug/passages/curves/curve.h>
#include <vug/passages/passages.h>
#include <vug/passages/sweep/segment.h>

#include <vector>

namespace vug::passages {

/// One for each point of the curve. Sections of consecutive points are one object if they are
/// equal, so that segments between them are uniform.
std::vector<SectionFrame> section_frames(const Curve& curve, const PassageOptions& options);

}  // namespace vug::passages

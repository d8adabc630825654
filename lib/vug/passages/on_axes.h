// SPDX-License-Identifier: Apache-2.0
// A network whose legs run through the middle of its passages, for points in their air.
#pragma once

#include <vug/network/network.h>
#include <vug/passages/passages.h>

namespace vug::passages {

/// The network with its legs on the axes of the passages that `passages` makes with the same
/// options: smooth curves with meanders, through the middle of the sections. Stations keep their
/// indices, names and flags, and lie on the axis; points of the curves between them are further
/// stations without names. Their cross-sections are half of the passage's width and height to each
/// side. Legs without a passage (over the surface, repeated, or without length) and splays are
/// omitted. Throws like `passages`.
network::Network on_axes(const network::Network& network, const PassageOptions& options = {});

}  // namespace vug::passages

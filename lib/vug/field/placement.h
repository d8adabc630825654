// SPDX-License-Identifier: Apache-2.0
// The map of a transformed node.
#pragma once

#include <vug/base/transform.h>
#include <vug/field/node.h>

#include <optional>

namespace vug::field {

/// The map by which `transformed` moves its only child; nothing for other nodes.
std::optional<Transform> placement_of(const Node& node);
/// The inverse of that map.
std::optional<Transform> inverse_placement_of(const Node& node);

}  // namespace vug::field

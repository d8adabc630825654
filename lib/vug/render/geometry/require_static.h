// SPDX-License-Identifier: Apache-2.0
// Rejects emissive objects that move.
#pragma once

#include <vug/render/scene.h>

namespace vug::render {

/// Emissive triangles are lights, which cannot move. Throws Error(bad_input) if the object is
/// emissive and moves.
void require_static(const Object& object);

}  // namespace vug::render

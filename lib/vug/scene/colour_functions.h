// SPDX-License-Identifier: Apache-2.0
// Built-in functions that return linear Rec.709 colours.
#pragma once

#include <vug/scene/functions.h>

#include <vector>

namespace vug::scene {

/// srgb, hsv, blackbody.
std::vector<Function> colour_functions();

}  // namespace vug::scene

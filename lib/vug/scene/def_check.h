// SPDX-License-Identifier: Apache-2.0
// The calls between the functions of a text.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>

namespace vug::scene {

/// Reports functions that call themselves, directly or through others, and removes their bodies.
/// Sets `work` of all functions.
void check_calls(Document& document, Diagnostics& diagnostics);

}  // namespace vug::scene

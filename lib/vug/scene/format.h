// SPDX-License-Identifier: Apache-2.0
// Formatter of scene texts.
#pragma once

#include <string>
#include <string_view>

namespace vug::scene {

/// The text with normalized spaces, indents and columns. Comments, line breaks and single blank
/// lines are kept. The result parses to an equal document, and formatting is idempotent. Intended
/// for texts without syntax errors; others remain readable.
std::string format(std::string_view text);

}  // namespace vug::scene

// SPDX-License-Identifier: Apache-2.0
// Values that editors display inside a text.
#pragma once

#include <vug/language/workspace.h>

#include <string>
#include <vector>

namespace vug::language {

/// A text to display after a position.
struct Hint {
  Position position;
  std::string text;
  std::string doc;
};

/// The values of params and lets between two lines whose expressions do not show them.
std::vector<Hint> inlay_hints(const Analysis& analysis, int first_line, int last_line);

}  // namespace vug::language

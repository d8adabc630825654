// SPDX-License-Identifier: Apache-2.0
// Counts with their nouns, for messages.
#pragma once

#include <string>

namespace vug {

/// "1 edit", "0 edits", "7 edits".
inline std::string pluralize(size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

}  // namespace vug

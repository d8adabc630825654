// SPDX-License-Identifier: Apache-2.0
// Names that every program accepts: unique, with letters, digits and underscores only.
#pragma once

#include <set>
#include <string>

namespace vug::exchange {

/// Replaces all other characters with underscores; the result begins with a letter or an
/// underscore.
std::string identifier(const std::string& text);

class UniqueNames {
 public:
  /// Like `identifier`, with a number appended if the name has been used before.
  std::string unique(const std::string& text);

 private:
  std::set<std::string> used_;
};

}  // namespace vug::exchange

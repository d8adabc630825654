// UniqueNames that every program takes: letters, digits and underscores, none twice.
#pragma once

#include <set>
#include <string>

namespace vug::exchange {

/// The text with an underscore in place of all else; begins with a letter or an underscore.
std::string identifier(const std::string& text);

class UniqueNames {
 public:
  /// As identifier, with a number behind it where that has been given before.
  std::string unique(const std::string& text);

 private:
  std::set<std::string> used_;
};

}  // namespace vug::exchange

// SPDX-License-Identifier: Apache-2.0
// Inside the expression parser only: the names around an expression, from which its random choices
// get their identity.
#pragma once

#include <string>
#include <string_view>

namespace vug::scene {

/// Appends a name to a path for its lifetime, also after an error.
class PathScope {
 public:
  PathScope(std::string& path, std::string_view name) : path_(path), size_(path.size()) {
    path_ += '/';
    path_ += name;
  }
  ~PathScope() { path_.resize(size_); }
  PathScope(const PathScope&) = delete;
  PathScope& operator=(const PathScope&) = delete;

 private:
  std::string& path_;
  size_t size_;
};

}  // namespace vug::scene

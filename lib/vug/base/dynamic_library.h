// SPDX-License-Identifier: Apache-2.0
// Shared libraries that are loaded when they are needed.
#pragma once

#include <span>
#include <string>

namespace vug {

/// A library that stays loaded for the rest of the process.
class DynamicLibrary {
 public:
  /// Loads the first of these files that exists. Errors begin with `subject`, e.g. "the library
  /// PROJ, which computes coordinates,". Functions are bound when they are called. Error(io) with
  /// the hint.
  DynamicLibrary(std::span<const char* const> files, std::string subject, std::string hint);

  /// Sets a pointer to the function of that name. Error(io) if the library lacks it.
  template <class Function>
  void find(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(address(name));
  }

 private:
  [[noreturn]] void fail(const std::string& why) const;
  void* address(const char* name) const;

  std::string subject_, hint_;
  void* library_ = nullptr;
};

}  // namespace vug

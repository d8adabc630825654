// SPDX-License-Identifier: Apache-2.0
#include <vug/base/dynamic_library.h>
#include <vug/base/error.h>

#include <dlfcn.h>
#include <fmt/format.h>

#include <utility>

namespace vug {

DynamicLibrary::DynamicLibrary(std::span<const char* const> files, std::string subject,
                               std::string hint)
    : subject_(std::move(subject)), hint_(std::move(hint)) {
  std::string reason;
  for (const char* const file : files) {
    library_ = dlopen(file, RTLD_LAZY | RTLD_LOCAL);
    if (library_) return;
    const char* const why = dlerror();
    if (reason.empty() && why) reason = why;
  }
  fail(fmt::format("cannot be loaded: {}", reason));
}

void DynamicLibrary::fail(const std::string& why) const {
  throw Error(ErrorCode::io, subject_ + " " + why, {}, hint_);
}

void* DynamicLibrary::address(const char* name) const {
  void* const found = dlsym(library_, name);
  if (!found) fail(fmt::format("lacks the function {}", name));
  return found;
}

}  // namespace vug

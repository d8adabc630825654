// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/image/backend.h>
#include <vug/image/backend_interface.h>

#include <dlfcn.h>
#include <fmt/format.h>

#include <string>

namespace vug::image {
namespace {

Error unusable(const std::string& why) {
  return Error(ErrorCode::io,
               fmt::format("the library '{}', which reads pictures, {}", VUG_IMAGE_FILES, why), {},
               "reinstall vug, or add the folder of the library to LD_LIBRARY_PATH");
}

template <class Function>
Function entry(void* library, const char* name) {
  return reinterpret_cast<Function>(dlsym(library, name));
}

const Backend& load() {
  // Found through the run path of the program, Python module or plugin that contains this code.
  // Lazy binding, because binding all functions of 250 libraries takes longer than loading them.
  void* const library = dlopen(VUG_IMAGE_FILES, RTLD_LAZY | RTLD_LOCAL);
  if (!library) {
    const char* const reason = dlerror();
    throw unusable(fmt::format("cannot be loaded: {}", reason ? reason : "unknown reason"));
  }
  const auto interface = entry<const char* (*)()>(library, kBackendInterfaceFunction);
  const auto functions = entry<const Backend* (*)()>(library, kBackendFunction);
  if (!interface || !functions) throw unusable("lacks its functions");
  if (std::string(interface()) != kBackendInterface)
    throw unusable(fmt::format("is the {}, but the {} is needed", interface(), kBackendInterface));
  return *functions();
}

}  // namespace

const Backend& backend() {
  static const Backend& loaded = load();
  return loaded;
}

}  // namespace vug::image

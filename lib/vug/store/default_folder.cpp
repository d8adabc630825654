// SPDX-License-Identifier: Apache-2.0
// The folder, the size and the server of the user's store, from the environment.
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/store/store.h>

#include <cstdlib>
#include <string>

namespace vug::store {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

std::filesystem::path default_folder() {
  const std::string own = variable("VUG_CACHE");
  if (own == "off") return {};
  if (!own.empty()) return own;
  // The specification of XDG ignores relative paths.
  if (const std::filesystem::path caches = variable("XDG_CACHE_HOME"); caches.is_absolute())
    return caches / "vug";
  const std::string home = variable("HOME");
  return home.empty() ? std::filesystem::path() : std::filesystem::path(home) / ".cache" / "vug";
}

std::string default_remote() { return variable("VUG_CACHE_REMOTE"); }

uint64_t default_max_bytes() {
  const std::string size = variable("VUG_CACHE_SIZE");
  if (size.empty()) return 0;
  try {
    return parse_bytes(size);
  } catch (Error& error) {
    throw error.within("reading the environment variable VUG_CACHE_SIZE");
  }
}

}  // namespace vug::store

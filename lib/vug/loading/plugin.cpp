// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/digester.h>
#include <vug/loading/plugin.h>
#include <vug/loading/plugin_kinds.h>
#include <vug/shot/cell_stages.h>

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <map>
#include <set>
#include <sstream>

namespace vug::loading {
namespace {

/// Collects the kinds first, so that an unusable plugin has no effect.
class KindCollector : public PluginKinds {
 public:
  void add(const cells::RuleKind& rule) override {
    static std::deque<Kind<shot::CellStagePtr>> stages;
    add_kind(ValueTraits<shot::CellStagePtr>::type(),
             registered_kind(stages.emplace_back(shot::stage_kind(rule))));
  }
  const std::vector<std::pair<std::string, RegisteredKind>>& all() const { return all_; }

 protected:
  void add_kind(const std::string& type, RegisteredKind kind) override {
    all_.emplace_back(type, std::move(kind));
  }

 private:
  std::vector<std::pair<std::string, RegisteredKind>> all_;
};

Error unusable(const std::filesystem::path& file, const std::string& why,
               const std::string& hint = {}) {
  return Error(ErrorCode::bad_input, fmt::format("the plugin '{}' {}", file.string(), why), {},
               hint);
}

template <class Function>
Function entry(void* library, const char* name) {
  return reinterpret_cast<Function>(dlsym(library, name));
}

std::map<std::filesystem::path, Digest>& loaded_plugins() {
  static std::map<std::filesystem::path, Digest> loaded;
  return loaded;
}

}  // namespace

void load_plugin(const std::filesystem::path& file) {
  auto& loaded = loaded_plugins();
  if (const std::string why = unreadable_reason(file); !why.empty())
    throw unusable(file, "cannot be read: " + why);
  const std::filesystem::path whole = std::filesystem::canonical(file);
  if (loaded.count(whole)) return;
  void* const library = dlopen(whole.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    const char* const message = dlerror();
    throw unusable(file, fmt::format("cannot be loaded: {}", message ? message : "unknown reason"));
  }
  const auto interface = entry<const char* (*)()>(library, "vug_plugin_interface");
  const auto give = entry<void (*)(PluginKinds&)>(library, "vug_plugin_kinds");
  if (!interface || !give)
    throw unusable(file, "is not a plugin: it lacks VUG_PLUGIN",
                   "docs/guides/plugins.md describes how to build one");
  if (std::string(interface()) != kPluginInterface)
    throw unusable(file,
                   fmt::format("was built for {}, but this is {}", interface(), kPluginInterface),
                   "rebuild it with the headers of this version");
  KindCollector kinds;
  give(kinds);
  try {
    add_kinds(kinds.all());
  } catch (const Error& error) {
    throw unusable(file, error.what(), error.hint());
  }
  loaded.emplace(whole, digest(read_text(whole)));
}

Digest digest_of_plugins() { return digest_of(loaded_plugins()); }

std::vector<std::filesystem::path> plugins_in_path() {
  std::vector<std::filesystem::path> plugins;
  const char* const path = std::getenv("VUG_PLUGIN_PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!std::filesystem::is_directory(folder)) continue;
    std::set<std::filesystem::path> here;
    for (const auto& each : std::filesystem::directory_iterator(folder))
      if (each.path().extension() == ".so") here.insert(each.path());
    plugins.insert(plugins.end(), here.begin(), here.end());
  }
  return plugins;
}

}  // namespace vug::loading

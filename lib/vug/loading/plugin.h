// SPDX-License-Identifier: Apache-2.0
// Interface of plugins: shared libraries whose kinds a scene can use like the built-in ones. A
// plugin is compiled against the headers of one version of Vug and entered through two C functions,
// so that an incompatible plugin is rejected before any of its code is used:
//
//   #include <vug/loading/plugin.h>
//   VUG_FIELD_KIND(lens) { return primitive_kind<Lens>("lens"); }   // as in field/primitives/
//   VUG_PLUGIN(kinds) { kinds.add(vug::field::lens_kind()); }
//
// docs/guides/plugins.md describes how to build plugins and where Vug searches for them.
#pragma once

#include <vug/base/hash.h>
#include <vug/cells/rule.h>
#include <vug/loading/kind_registry.h>

#include <filesystem>
#include <string>
#include <vector>

/// Incremented whenever the source of plugins has to change.
#define VUG_PLUGIN_INTERFACE "1"

namespace vug::loading {

/// The interface that a plugin must have been compiled for. It includes the version, since classes
/// are shared.
inline constexpr const char* kPluginInterface = "interface " VUG_PLUGIN_INTERFACE " of vug "
#include <vug/loading/version.inc>
    ;

/// Receives the kinds of a plugin, which must live as long as the process.
class PluginKinds {
 public:
  virtual ~PluginKinds() = default;

  /// Adds a kind of any registry: a field, a mask, a material, a light, ...
  template <class Product>
  void add(const Kind<Product>& kind) {
    add_kind(ValueTraits<Product>::type(), registered_kind(kind));
  }
  /// Adds a cell rule.
  virtual void add(const cells::RuleKind& rule) = 0;

 protected:
  virtual void add_kind(const std::string& type, RegisteredKind kind) = 0;
};

/// Loads a plugin for the rest of the process; further calls have no effect. Error(bad_input): the
/// file is not a plugin or has another interface, its kinds already exist, or kinds are already in
/// use (load plugins before the first scene).
void load_plugin(const std::filesystem::path& file);

/// Identifies the code of all plugins that have been loaded, by the content of their files.
Digest digest_of_plugins();

/// The plugins in the folders of $VUG_PLUGIN_PATH, which are separated by colons: all .so files,
/// folder by folder, sorted by name in each.
std::vector<std::filesystem::path> plugins_in_path();

}  // namespace vug::loading

/// Begins the definition of the function that a plugin exports; `kinds` is a PluginKinds.
// NOLINTBEGIN(bugprone-macro-parentheses): the macro argument names a parameter
#define VUG_PLUGIN(kinds)                                                                \
  extern "C" __attribute__((visibility("default"))) const char* vug_plugin_interface() { \
    return vug::loading::kPluginInterface;                                               \
  }                                                                                      \
  extern "C" __attribute__((visibility("default"))) void vug_plugin_kinds(               \
      vug::loading::PluginKinds& kinds)
// NOLINTEND(bugprone-macro-parentheses)

// What a plugin is made with: a shared library whose kinds a scene can use like those that come
// with us. It is written in C++ against the headers of the Vug it is for, and entered through two
// functions of C, so that one that does not fit is refused before anything of it is used:
//
//   #include <vug/loading/plugin.h>
//   VUG_FIELD_KIND(lens) { return primitive_kind<Lens>("lens"); }   // as in field/primitives/
//   VUG_PLUGIN(kinds) { kinds.add(vug::field::lens_kind()); }
//
// docs/guides/plugins.md shows how one is built, and where it is looked for.
#pragma once

#include <vug/cells/rule.h>
#include <vug/loading/kind_registry.h>

#include <filesystem>
#include <string>
#include <vector>

/// Counts up whenever plugins have to be written differently.
#define VUG_PLUGIN_INTERFACE "1"

namespace vug::loading {

/// What a plugin has to be made for. The version counts, too: classes are shared.
inline constexpr const char* kPluginInterface = "interface " VUG_PLUGIN_INTERFACE " of vug "
#include <vug/loading/version.inc>
    ;

/// Takes the kinds that a plugin brings; they must live as long as the process.
class PluginKinds {
 public:
  virtual ~PluginKinds() = default;

  /// Any family's: a field, a mask, a material, a light, ...
  template <class Product>
  void add(const Kind<Product>& kind) {
    add_kind(ValueTraits<Product>::type(), registered_kind(kind));
  }
  /// A rule of cells.
  virtual void add(const cells::RuleKind& rule) = 0;

 protected:
  virtual void add_kind(const std::string& type, RegisteredKind kind) = 0;
};

/// Loads a plugin, for the rest of the process; a second time there is nothing to do.
/// Error(bad_input): no plugin, one that is made for another interface, kinds that are there
/// already; also after the first scene was read or the kinds were asked for.
void load_plugin(const std::filesystem::path& file);

/// The plugins in the folders of $VUG_PLUGIN_PATH, which stand between colons: all files that end
/// in .so, folder by folder and in each by name.
std::vector<std::filesystem::path> plugins_in_path();

}  // namespace vug::loading

/// Opens the one definition that a plugin exports beside its interface; `kinds` is a PluginKinds.
// NOLINTBEGIN(bugprone-macro-parentheses): it names a parameter
#define VUG_PLUGIN(kinds)                                                                \
  extern "C" __attribute__((visibility("default"))) const char* vug_plugin_interface() { \
    return vug::loading::kPluginInterface;                                               \
  }                                                                                      \
  extern "C" __attribute__((visibility("default"))) void vug_plugin_kinds(               \
      vug::loading::PluginKinds& kinds)
// NOLINTEND(bugprone-macro-parentheses)

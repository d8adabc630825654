// From a scene file to a shot.
#pragma once

#include <vug/scene/document.h>
#include <vug/scene/evaluator.h>
#include <vug/shot/shot.h>

#include <filesystem>

namespace vug::loading {

/// What a text declares that is the same in every frame, by kind and name.
struct StaticCache {
  struct Entry {
    Value value;
    shot::Shot shot;                    ///< What the declaration adds to it.
    std::optional<Digest> text_digest;  ///< Shot::texts with those that it takes in.
  };
  std::map<std::pair<std::string, std::string>, Entry> declarations;
};

struct LoadOptions {
  std::vector<scene::Override> overrides;               ///< -D NAME=VALUE, in order.
  std::optional<uint64_t> seed;                         ///< Instead of the scene's.
  std::vector<std::filesystem::path> include_folders;   ///< After the scene's own folder.
  std::vector<std::filesystem::path> enclosing_scenes;  ///< Scenes that place this one.
  double frame = 1;                                     ///< The moment to show.
  /// Bytes of a word that an L-system grows while the scene is read; 0: what the machine can give.
  uint64_t max_memory = 0;
  /// Of the same text, overrides and seed: what stands still is taken from here, as the very same
  /// objects, and what is found to do so goes there. May be null.
  StaticCache* static_cache = nullptr;
};

/// A parameter of a scene, as data for whoever shows or changes it.
struct Parameter {
  std::string name;
  Value value;      ///< Of this run.
  Value fallback;   ///< Without overrides.
  Value low, high;  ///< Both ends of its range; empty without one.
  std::string doc;
  SourceLocation where;  ///< Its name in the text.
};

/// A loaded scene. When `diagnostics` has errors the shot is incomplete and must not be used.
struct Loaded {
  shot::Shot shot;
  Diagnostics diagnostics;
  std::vector<std::shared_ptr<const scene::Source>> sources;
  std::vector<Parameter> parameters;  ///< In the order of the text.

  bool usable() const { return !diagnostics.has_errors(); }
  /// The diagnostics with their lines and carets, as `vug check` prints them.
  std::string report() const { return report(diagnostics); }
  /// Others in the same way, as of what shows while the scene is built.
  std::string report(const Diagnostics& others) const;
};

/// Reads, parses and evaluates the whole scene; derives its grammars. All faults of the text are
/// collected. Error(bad_input) only when the file cannot be read at all.
Loaded load(const std::filesystem::path& file, const LoadOptions& options = {});
/// The same from text; `file` names it in messages and is where relative paths start.
Loaded load_text(std::string text, const std::string& file, const LoadOptions& options = {});

}  // namespace vug::loading

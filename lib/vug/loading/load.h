// SPDX-License-Identifier: Apache-2.0
// Loads a scene file and evaluates it to a shot, with the cache of values that do not depend on the
// frame.
#pragma once

#include <vug/loading/provenance.h>
#include <vug/scene/document.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/file_reader.h>
#include <vug/shot/shot.h>

#include <filesystem>

namespace vug::loading {

/// The declarations that do not depend on the frame, by kind and name; those of a loop as
/// "NAME[0]", ..., and as "NAME" without a value.
struct StaticCache {
  struct Entry {
    Value value;
    shot::Shot shot;                    ///< The additions of the declaration.
    std::optional<Digest> text_digest;  ///< Shot::text_digest after the declaration, if it changed.
    Digest inputs;  ///< The text that determines the value; see scene::StatementDigests.
    /// The declarations that the value uses, in the order of their evaluation, with the numbers of
    /// their values; 0 for a value that is not in the cache.
    std::vector<std::pair<scene::DeclarationName, uint64_t>> uses = {};
    SourceLocation extent = {};  ///< The text of the declaration.
    uint64_t number = 0;         ///< Distinguishes the value from all others.
  };
  std::map<scene::DeclarationName, Entry> declarations;
  uint64_t last_number = 0;
  size_t reused = 0;  ///< Values that the last evaluation of a text took from the cache.
};

struct LoadOptions {
  std::vector<scene::Override> overrides;              ///< -D NAME=VALUE, in order.
  std::string variant;                                 ///< Name of a variant; empty: none.
  std::vector<std::string> appended;                   ///< Further statements of the text.
  std::string expression;                              ///< Evaluated as Loaded::value; or empty.
  std::optional<uint64_t> seed;                        ///< Overrides the scene's seed.
  std::vector<std::filesystem::path> include_folders;  ///< Searched after the scene's own folder.
  std::vector<std::filesystem::path>
      enclosing_scenes;  ///< The chain of scenes that place this one.
  double frame = 1;      ///< The frame to evaluate.
  bool draft = false;    ///< Sets Shot::draft.
  /// Memory limit in bytes for the word of an L-system; 0: the machine's free memory.
  uint64_t max_memory = 0;
  /// Cache of static declarations for the same overrides, variant, folders and seed. Values whose
  /// text is the same as before are reused as the identical objects, and new static values are
  /// added. Diagnostics of reused declarations are not repeated. May be null.
  StaticCache* static_cache = nullptr;
  /// Makes cameras { scout N } default cameras, without the lamps of their shots: for the search of
  /// new shots.
  bool unscouted = false;
  /// Reads the included files, e.g. the texts that are open in an editor; empty: from the disk.
  scene::FileReader read = {};
};

/// A parameter of a scene, for programs that display or change it.
struct Parameter {
  std::string name;
  Value value;      ///< Value in this run.
  Value fallback;   ///< Default without overrides.
  Value low, high;  ///< Limits of its range; empty without a range.
  std::string doc;
  SourceLocation where;  ///< Location of the name in the text.
};

/// A named set of parameter values.
struct Variant {
  std::string name;
  NamedValues values;
  SourceLocation where;  ///< Location of the name in the text.
};

/// A loaded scene. If `diagnostics` has errors, the shot is incomplete and must not be used.
struct Loaded {
  shot::Shot shot;
  Diagnostics diagnostics;
  std::vector<std::shared_ptr<const scene::Source>> sources;
  std::vector<Parameter> parameters;  ///< In the order of the text.
  std::vector<Variant> variants;      ///< In the order of the text.
  /// The functions that the text can call, in its order; those of modules have their prefix.
  std::vector<KindInfo> functions;
  Value value;                 ///< That of LoadOptions::expression.
  ProvenanceTable provenance;  ///< The text from which each thing was made.

  bool usable() const { return !diagnostics.has_errors(); }
  /// The diagnostics with source lines and carets, as printed by `vug check`.
  std::string report() const { return report(diagnostics); }
  /// Formats other diagnostics in the same way, for instance warnings of the Builder.
  std::string report(const Diagnostics& others) const;
};

/// A text with the statements that are appended to it.
std::string joined_text(std::string text, const std::vector<std::string>& appended);

/// Reads, parses and evaluates the whole scene, and derives its grammars. All faults of the text
/// are collected in `diagnostics`. Error(bad_input) only if the file cannot be read.
Loaded load(const std::filesystem::path& file, const LoadOptions& options = {});
/// Loads a scene from text. `file` is its name in messages and the base of relative paths.
Loaded load_text(std::string text, const std::string& file, const LoadOptions& options = {});

}  // namespace vug::loading

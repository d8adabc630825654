// SPDX-License-Identifier: Apache-2.0
// Options shared by verbs: of the scene (-D, --seed, --frame, --quality) and of the work
// (--threads, --max-memory, --quiet).
#pragma once

#include "progress_bar.h"
#include "verb.h"

#include <vug/building/builder.h>
#include <vug/loading/scene_source.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::cli {

struct WorkOptions;

/// The scene file and the values that replace its own.
struct SceneOptions {
  std::string scene;
  std::vector<std::string> defines;
  std::string variant;
  std::optional<uint64_t> seed;
  std::optional<double> frame;
  bool strict = false;     ///< Warnings about the scene are errors.
  std::string quality;     ///< Name of a shot::Quality; empty: none.
  bool unscouted = false;  ///< See loading::LoadOptions; not an option of the command.

  /// `work`: the options of the same verb, or null. Its limits also apply while the scene is
  /// loaded.
  void add_to(CLI::App& app, const WorkOptions* work = nullptr);
  /// Loads the scene; prints its diagnostics on stderr. Throws ExitRequest{kUnusable} when it has
  /// errors.
  loading::Loaded load() const;
  /// The scene, to be loaded at several frames. Error(bad_input) if the file cannot be read.
  loading::SceneSource source() const;
  /// Loads a frame of `source()` in the same way.
  loading::Loaded load(const loading::SceneSource& source, double at) const;
  loading::LoadOptions load_options() const;
  /// With `--strict`, makes the warnings errors.
  void apply_strictness(Diagnostics& diagnostics) const;

 private:
  void refuse_survey() const;
  ProgressBarMode bar_mode() const;

  const WorkOptions* work_ = nullptr;
};

/// Threads, memory limit and progress output of a run.
struct WorkOptions {
  int threads = 0;
  std::string max_memory;
  bool quiet = false;
  bool progress = false;
  bool no_cache = false;

  void add_to(CLI::App& app);
  ProgressBarMode bar_mode() const;
  /// The limit in bytes: --max-memory, or nine tenths of the free memory.
  uint64_t memory_limit() const;
  /// Options of a builder with that limit, which prints warnings to stderr as they occur. `loaded`
  /// must outlive the builder.
  building::BuildOptions build_options(const loading::Loaded& loaded) const;
  /// Reports on stderr the components that were removed from the meshes, and the time of each
  /// stage, unless quiet.
  void summarise(const building::Builder& builder) const;
};

}  // namespace vug::cli

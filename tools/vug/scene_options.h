// Options that every verb with a scene shares.
#pragma once

#include "progress_bar.h"
#include "verb.h"

#include <vug/building/builder.h>
#include <vug/loading/load.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::cli {

struct WorkOptions;

struct SceneOptions {
  std::string scene;
  std::vector<std::string> defines;
  std::optional<uint64_t> seed;
  std::optional<double> frame;

  /// `work`: of the same verb, may be null; its limits hold while the scene is loaded, too.
  void add_to(CLI::App& app, const WorkOptions* work = nullptr);
  /// Loads the scene; prints its diagnostics on stderr. Throws ExitRequest{kUnusable} when it has
  /// errors.
  loading::Loaded load() const;
  /// The same at a frame of a sequence; see loading::Still.
  loading::Loaded load(double at, loading::StaticCache& static_cache) const;
  /// For PictureOptions::moment; the options and `still` must outlive it.
  std::function<std::shared_ptr<const shot::Shot>(double)> shot_at_frame(
      loading::StaticCache& static_cache) const;
  loading::LoadOptions load_options() const;

 private:
  const WorkOptions* work_ = nullptr;

  loading::Loaded load(const loading::LoadOptions& options) const;
};

struct WorkOptions {
  int threads = 0;
  std::string max_memory;
  bool quiet = false;
  bool progress = false;

  void add_to(CLI::App& app);
  ProgressBarMode bar_mode() const;
  /// In bytes; without --max-memory nine tenths of what the machine has free.
  uint64_t memory_limit() const;
  /// Within that limit; warnings go to stderr as they come. `loaded` must outlive what is built.
  building::BuildOptions build_options(const loading::Loaded& loaded) const;
  /// Tells on stderr what was left out of the meshes, unless quiet.
  void summarise(const building::Builder& builder) const;
};

}  // namespace vug::cli

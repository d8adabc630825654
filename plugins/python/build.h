// SPDX-License-Identifier: Apache-2.0
// Builds of a scene, as seen from Python, with the progress callbacks of a build and of its single
// calls.
#pragma once

#include "image.h"
#include "scene.h"

#include "background_work.h"

#include <vug/building/builder.h>
#include <vug/picture/render_job.h>

#include <functional>
#include <memory>
#include <variant>

namespace vug::python {

/// A memory limit: bytes, a text such as "8G", or no value for nine tenths of the free memory.
using Memory = std::optional<std::variant<int64_t, std::string>>;

struct BuildSettings {
  uint64_t max_memory = 0;  ///< Bytes.
  int threads = 0;          ///< 0: all cores.
  Callback progress;
  std::filesystem::path checkpoint = {};  ///< Checkpoint of cell simulations; empty: none.
};

/// A Builder with its scene, which reports its progress to Python.
class Build {
 public:
  Build(ScenePtr scene, BuildSettings settings);
  /// Builds another shot of the scene.
  Build(ScenePtr scene, std::shared_ptr<const shot::Shot> shot, BuildSettings settings);

  /// Calls `work` with the builder on a separate thread (see run_in_background). RuntimeError while
  /// another call runs, because a builder must not be used concurrently. Cancelled work can be
  /// requested again.
  void work(const std::function<void(building::Builder&)>& work);

  /// Replaces the progress callback of a build during its lifetime. An empty callback changes
  /// nothing.
  class ProgressOverride {
   public:
    ProgressOverride(Build& build, const Callback& progress)
        : build_(build), own_(build.settings_.progress) {
      if (progress && !build.busy_) build.settings_.progress = progress;
    }
    ~ProgressOverride() { build_.settings_.progress = own_; }
    ProgressOverride(const ProgressOverride&) = delete;
    ProgressOverride& operator=(const ProgressOverride&) = delete;

   private:
    Build& build_;
    Callback own_;
  };

  const ScenePtr& scene() const { return scene_; }
  BuildSettings& settings() { return settings_; }

 private:
  /// A builder with its own Progress, which remains cancelled once it is cancelled.
  struct Context;
  std::unique_ptr<Context> open();

  ScenePtr scene_;
  std::shared_ptr<const shot::Shot> shot_;
  BuildSettings settings_;
  std::shared_ptr<Context> context_;
  bool busy_ = false;  ///< Guarded by the interpreter's lock.
};

/// The limit in bytes. ValueError for a limit below 1.
uint64_t memory_limit_of(const Memory& given);
/// The argument itself. ValueError unless it is from 0 to 1024.
int checked_threads(int given);

/// The arguments of `render`.
struct RenderArguments {
  picture::PictureOptions picture;
  picture::RenderOptions render;
  bool anyway = false;  ///< Render in spite of mistakes of placement.
};
/// From the name of the render block and the keyword arguments. The scene must outlive the result.
RenderArguments render_arguments(const Scene& scene, const std::string& name,
                                 const py::kwargs& given);
/// The documentation of `render`, which lists all arguments.
std::string render_doc();

Image render(Build& build, const RenderArguments& arguments);

}  // namespace vug::python

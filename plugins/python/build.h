// What is made of a scene, as Python holds it.
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

/// Bytes, a text such as "8G", or nothing: nine tenths of what is free.
using Memory = std::optional<std::variant<int64_t, std::string>>;

struct BuildSettings {
  uint64_t max_memory = 0;  ///< Bytes.
  int threads = 0;          ///< 0: all cores.
  Callback progress;
  std::filesystem::path checkpoint = {};  ///< Of runs of cells; empty: none is kept.
};

/// A Builder with its scene, that tells Python how it gets on.
class Build {
 public:
  Build(ScenePtr scene, BuildSettings settings);
  /// Of another shot of the scene's.
  Build(ScenePtr scene, std::shared_ptr<const shot::Shot> shot, BuildSettings settings);

  /// Calls `work` with the builder, on a thread of its own (see follow). RuntimeError while another
  /// does: a builder is not for several at once. What was cancelled can be asked for again.
  void work(const std::function<void(building::Builder&)>& work);

  /// While it lives another callback is told how the build gets on; none leaves it as it is.
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
  /// A builder with its own progress, which stays cancelled once it was.
  struct Context;
  std::unique_ptr<Context> open();

  ScenePtr scene_;
  std::shared_ptr<const shot::Shot> shot_;
  BuildSettings settings_;
  std::shared_ptr<Context> context_;
  bool busy_ = false;  ///< Guarded by the interpreter's lock.
};

uint64_t memory_limit_of(const Memory& given);
int checked_threads(int given);

/// The options of `render` by their names in Python.
picture::RenderOptions render_options(const Scene& scene, const py::kwargs& given);

Image render(Build& build, const picture::RenderOptions& options);

}  // namespace vug::python

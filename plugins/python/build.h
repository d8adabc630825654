// What is made of a scene, as Python holds it.
#pragma once

#include "image.h"
#include "scene.h"

#include "follow.h"

#include <vug/session/build.h>
#include <vug/session/long_render.h>

#include <functional>
#include <memory>

namespace vug::python {

struct BuildSettings {
  uint64_t max_memory = 0;  ///< Bytes.
  int threads = 0;          ///< 0: all cores.
  py::object progress = py::none();
};

/// A Builder with its scene, that tells Python how it gets on.
class Build {
 public:
  Build(ScenePtr scene, BuildSettings settings);

  /// Calls `work` with the builder, on a thread of its own (see follow). RuntimeError while another
  /// does: a builder is not for several at once. What was cancelled can be asked for again.
  void work(const std::function<void(session::Builder&)>& work);

  const ScenePtr& scene() const { return scene_; }
  BuildSettings& settings() { return settings_; }

 private:
  /// A builder with its own progress, which stays cancelled once it was.
  struct Shop;
  std::unique_ptr<Shop> open();

  ScenePtr scene_;
  BuildSettings settings_;
  std::shared_ptr<Shop> shop_;
  bool busy_ = false;  ///< Guarded by the interpreter's lock.
};

/// Bytes of None (nine tenths of what is free), a number, or a text such as "8G".
uint64_t memory_of(const py::object& given);
int threads_of(int given);

/// The options of `render` by their names in Python.
session::RenderOptions render_options(const Scene& scene, const py::kwargs& given);

Image render(Build& build, const session::RenderOptions& options);

}  // namespace vug::python

// SPDX-License-Identifier: Apache-2.0
#include "build.h"
#include "errors.h"

#include <vug/base/memory.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/loading/plugin.h>

namespace vug::python {

struct Build::Context {
  Context(const Scene& scene, const shot::Shot& shot, const BuildSettings& settings)
      : progress([this](const std::string& stage, double share) { queue.report(stage, share); }),
        builder(shot, options(scene, shot, settings), progress) {}

  building::BuildOptions options(const Scene& scene, const shot::Shot& shot,
                                 const BuildSettings& settings) {
    building::BuildOptions out;
    out.max_memory = settings.max_memory;
    if (!settings.checkpoint.empty())
      out.checkpoint = std::make_shared<building::CellsCheckpoint>(
          building::CheckpointOptions{settings.checkpoint, std::nullopt, true}, shot);
    if (!scene.loaded().sources.empty())
      out.stored = building::user_store(scene.loaded().sources.front()->file,
                                        loading::digest_of_plugins(), nullptr);
    out.on_warning = [this, &scene](const Diagnostics& doubtful) {
      queue.warn(warnings_of(scene.loaded(), doubtful));
    };
    return out;
  }

  EventQueue queue;
  Progress progress;
  building::Builder builder;
};

Build::Build(ScenePtr scene, BuildSettings settings)
    : Build(scene, {scene, &scene->shot()}, std::move(settings)) {}

Build::Build(ScenePtr scene, std::shared_ptr<const shot::Shot> shot, BuildSettings settings)
    : scene_(std::move(scene)), shot_(std::move(shot)), settings_(std::move(settings)) {
  context_ = open();
}

std::unique_ptr<Build::Context> Build::open() {
  return std::make_unique<Context>(*scene_, *shot_, settings_);
}

void Build::work(const std::function<void(building::Builder&)>& work) {
  if (busy_) {
    PyErr_SetString(PyExc_RuntimeError, "this build is already running");
    throw py::error_already_set();
  }
  if (context_->progress.cancelled()) {
    std::unique_ptr<Context> next = open();
    next->builder.reuse_from(std::move(context_->builder));
    context_ = std::move(next);
  }
  struct Busy {
    explicit Busy(bool& flag) : flag_(flag) { flag_ = true; }
    ~Busy() { flag_ = false; }
    bool& flag_;
  } const busy(busy_);
  run_in_background(context_->queue, context_->progress, settings_.progress, settings_.threads,
                    [&] { work(context_->builder); });
}

uint64_t memory_limit_of(const Memory& given) {
  if (!given) return available_memory() / 10 * 9;
  if (const auto* text = std::get_if<std::string>(&*given)) return parse_bytes(*text);
  const int64_t bytes = std::get<int64_t>(*given);
  if (bytes < 1) throw py::value_error("max_memory must be above 0");
  return static_cast<uint64_t>(bytes);
}

int checked_threads(int given) {
  if (given < 0 || given > 1024) throw py::value_error("threads must be 0 (all cores) to 1024");
  return given;
}

}  // namespace vug::python

// A scene at one frame of a sequence.
#pragma once

#include "scene_options.h"

#include <utility>

namespace vug::cli {

/// What is loaded of it, and a builder that tells of its text.
struct SceneAtFrame {
  explicit SceneAtFrame(loading::Loaded from, const WorkOptions& work, Progress& progress)
      : loaded(std::move(from)), builder(loaded.shot, work.build_options(loaded), progress) {}
  loading::Loaded loaded;
  building::Builder builder;
};

}  // namespace vug::cli

// SPDX-License-Identifier: Apache-2.0
// A scene at one frame of a sequence, with its builder.
#pragma once

#include "scene_options.h"

#include <utility>

namespace vug::cli {

/// The loaded scene and a builder whose diagnostics refer to its text.
struct SceneAtFrame {
  explicit SceneAtFrame(loading::Loaded from, const WorkOptions& work, Progress& progress)
      : loaded(std::move(from)), builder(loaded.shot, work.build_options(loaded), progress) {}
  loading::Loaded loaded;
  building::Builder builder;
};

}  // namespace vug::cli

// SPDX-License-Identifier: Apache-2.0
// Renders a scene again and again, whenever one of its files is saved, until it is stopped.
#pragma once

#include "watch/look_requests.h"

#include <vug/watch/live_scene.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::cli {

/// The picture of a version, or a stage of it.
struct WatchedPicture {
  const std::vector<picture::PictureView>& views;
  bool complete = false;
  double seconds = 0;  ///< Since the change was noticed.
  watch::Work work;
};

/// The receivers of what happens; called on the thread of the loop.
struct WatchEvents {
  std::function<void(const WatchedPicture&)> picture;
  /// The problems of the text, and what could not be built or rendered.
  std::function<void(const Diagnostics& problems, const std::string& report)> problems;
};

struct WatchOptions {
  bool once = false;  ///< End after the first picture or error.
  bool polling = false;
};

/// Loads and renders the scene, and again after each change; a change cancels the picture that is
/// being rendered, and so does a look, after which it continues. Returns false if the last version
/// has errors. Ends once `stop` is cancelled, within a tenth of a second as far as the work can be
/// cancelled.
bool run_watch_loop(watch::LiveScene& scene, const WatchOptions& options, const WatchEvents& events,
                    const std::function<std::shared_ptr<Progress>()>& new_progress,
                    LookRequests& looks, const Progress& stop);

}  // namespace vug::cli

// SPDX-License-Identifier: Apache-2.0
// The page of `vug watch`, for browsers on this machine.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/watch/live_scene.h>

#include <functional>
#include <memory>
#include <string>

namespace vug::cli {

/// What the page shows next to the picture.
struct PageStatus {
  bool complete = false;
  double seconds = 0;   ///< Since the change was noticed.
  std::string work;     ///< A sentence about what was built and kept.
  std::string camera;   ///< Its name; empty if the text has none.
  viewport::View view;  ///< The view of the camera.
};

/// The PNG of a view, on the thread of a request; empty if it was superseded.
using Look = std::function<std::string(const watch::ViewRequest&)>;

/// Serves the page on the loopback address only. Its address contains a random token, and a request
/// without it, for another host name (a name that an attacker points to this machine) or with
/// another method than GET is refused. The page loads nothing from elsewhere. All functions may be
/// called while requests are answered.
class PageServer {
 public:
  /// `port` 0: any free one. Error(io) if the port cannot be used.
  PageServer(int port, std::string title, Look look);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// The address of the page, with its token.
  const std::string& url() const { return url_; }
  /// Replaces the picture, a PNG.
  void show_picture(std::string png, const PageStatus& status);
  /// Replaces the list of problems.
  void show_problems(const Diagnostics& problems);

 private:
  struct State;
  std::string url_;
  std::unique_ptr<State> state_;
};

}  // namespace vug::cli

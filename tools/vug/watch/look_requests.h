// SPDX-License-Identifier: Apache-2.0
// Requests of browsers for looks at a scene from eyes of their own.
#pragma once

#include <vug/watch/live_scene.h>

#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace vug::cli {

/// Passes a request from the thread of a browser to that of the renderer. Only the last request
/// counts: the others are answered with an empty text. Thread-safe.
class LookRequests {
 public:
  /// Called on the thread of the request after it has been added.
  void on_request(std::function<void()> notify) {
    const std::lock_guard lock(mutex_);
    notify_ = std::move(notify);
  }
  /// Asks for a look and waits for the PNG; empty if a later request, an edit or the end of the
  /// program came first.
  std::string ask(const watch::ViewRequest& look) {
    std::future<std::string> png;
    {
      const std::lock_guard lock(mutex_);
      if (closed_) return "";
      if (pending_) pending_->png.set_value("");
      pending_.emplace(Request{look, {}});
      png = pending_->png.get_future();
      if (notify_) notify_();
    }
    return png.get();
  }
  bool has_request() {
    const std::lock_guard lock(mutex_);
    return pending_.has_value();
  }
  /// Answers the request, if there is one, with the text that `render` returns.
  template <class Look>
  void answer(const Look& render) {
    std::optional<Request> request;
    {
      const std::lock_guard lock(mutex_);
      request = std::exchange(pending_, std::nullopt);
    }
    if (!request) return;
    std::string png;
    try {
      png = render(request->look);
    } catch (...) {
      request->png.set_value("");
      throw;
    }
    request->png.set_value(std::move(png));
  }
  /// Answers all requests, also later ones, with an empty text.
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    notify_ = nullptr;
    if (pending_) pending_->png.set_value("");
    pending_.reset();
  }

 private:
  struct Request {
    watch::ViewRequest look;
    std::promise<std::string> png;
  };
  std::mutex mutex_;
  std::function<void()> notify_;
  std::optional<Request> pending_;
  bool closed_ = false;
};

}  // namespace vug::cli

// SPDX-License-Identifier: Apache-2.0
// A scene text that can be evaluated at any frame.
#pragma once

#include <vug/loading/load.h>

#include <memory>
#include <mutex>

namespace vug::loading {

/// The text of a scene and its load options. The text is read once, and everything that does not
/// depend on the frame is evaluated once and shared by all frames, and by versions of the text that
/// leave it as it is (see StaticCache). Any thread may call its functions.
class SceneSource {
 public:
  /// `options`: `frame` and `static_cache` are ignored.
  SceneSource(std::string text, std::string file, LoadOptions options = {});
  /// Error(bad_input) if the file cannot be read.
  explicit SceneSource(const std::filesystem::path& file, LoadOptions options = {});

  /// The scene at a frame. All faults of the text are in its diagnostics.
  Loaded at(double frame) const;
  /// The scene with the value of an expression (LoadOptions::expression).
  Loaded evaluate(const std::string& expression, double frame) const;
  /// The shot at a frame. Error(bad_input) with the first fault of the text.
  std::shared_ptr<const shot::Shot> shot_at(double frame) const;

  /// Replaces the text by another version of it. No other thread may use this object meanwhile.
  void set_text(std::string text) { text_ = std::move(text); }
  /// Forgets all values, after a file that no text names has changed.
  void forget_values() { static_cache_ = {}; }
  /// Declarations whose values the last evaluation took from those before.
  size_t reused() const { return static_cache_.reused; }

  const std::string& text() const { return text_; }
  const std::string& file() const { return file_; }

 private:
  std::string text_;
  std::string file_;
  LoadOptions options_;
  mutable StaticCache static_cache_;
  mutable std::mutex mutex_;  ///< Guards static_cache_.
};

}  // namespace vug::loading

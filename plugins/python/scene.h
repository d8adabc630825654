// SPDX-License-Identifier: Apache-2.0
// Scenes, as seen from Python.
#pragma once

#include "binding.h"

#include <vug/loading/load.h>

#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace vug::python {

/// The options with which a scene is loaded.
struct LoadSettings {
  loading::LoadOptions load;
  std::set<std::string> numbers;  ///< Overrides given as numbers; angles are in radians.
};

/// A loaded scene with its text and options, so that it can be loaded again with other parameters
/// or at another frame. It is shared by all its products.
class Scene {
 public:
  /// Throws vug.Error with all errors of the text; issues its warnings.
  Scene(std::string text, std::string file, LoadSettings settings);

  const loading::Loaded& loaded() const { return loaded_; }
  const shot::Shot& shot() const { return loaded_.shot; }
  const std::string& text() const { return text_; }
  const std::string& file() const { return file_; }
  const LoadSettings& settings() const { return settings_; }

  /// Loads the scene at a frame and reuses everything that does not depend on the frame. Errors are
  /// in the diagnostics of the result.
  loading::Loaded at(double frame) const;
  /// The function for PictureOptions::shot_at_frame. Any thread may call it during the lifetime of
  /// the scene.
  std::function<std::shared_ptr<const shot::Shot>(double)> shot_at_frame() const;

 private:
  std::string text_;
  std::string file_;
  LoadSettings settings_;
  mutable loading::StaticCache static_cache_;  ///< Shared by all frames.
  mutable std::mutex load_mutex_;              ///< Guards static_cache_.
  loading::Loaded loaded_;
};
using ScenePtr = std::shared_ptr<const Scene>;

/// A derivation of a scene, which it keeps alive.
struct Derivation {
  ScenePtr scene;
  const shot::Derivation* derivation;

  const grammar::Tree& tree() const { return derivation->tree; }
};

/// The text after `-D NAME=` for a value from Python: a number, bool or vector; a str is text of
/// the scene language, and a path becomes a quoted string. Throws TypeError or ValueError.
std::string override_text(const std::string& name, const py::handle& value);

/// Converts a value to None, a number, a bool, a str, a tuple of three numbers, or a list of these,
/// in metres and radians.
py::object to_python(const Value& value);

}  // namespace vug::python

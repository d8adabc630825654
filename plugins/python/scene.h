// SPDX-License-Identifier: Apache-2.0
// Scenes, as seen from Python.
#pragma once

#include "binding.h"

#include <vug/loading/scene_source.h>

#include <memory>
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
  /// The text without the statements that are appended to it.
  const std::string& text() const { return source_->text(); }
  const std::string& file() const { return source_->file(); }
  const LoadSettings& settings() const { return settings_; }
  /// The scene at other frames.
  const loading::SceneSource& source() const { return *source_; }

 private:
  LoadSettings settings_;
  std::unique_ptr<const loading::SceneSource> source_;
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

/// The text of an argument of a function: like override_text, and lists. A tuple or array of three
/// numbers is a vector; all other sequences are lists.
std::string argument_text(const std::string& name, const py::handle& value);

/// Converts a value to None, a number, a bool, a str, a tuple of three numbers, or a list of these,
/// in metres and radians.
py::object to_python(const Value& value);

/// The same for a value that must not contain objects. Throws TypeError.
py::object to_plain_python(const Value& value);

}  // namespace vug::python

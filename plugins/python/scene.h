// Scenes as Python holds them.
#pragma once

#include "binding.h"

#include <vug/loading/load.h>

#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace vug::python {

/// What a scene is loaded with.
struct LoadSettings {
  loading::LoadOptions load;
  std::set<std::string> numbers;  ///< Overrides that are Python's numbers: angles are radians.
};

/// A loaded scene and what it was loaded from, so that it can be loaded with other parameters or at
/// another moment. Shared by all that is made of it.
class Scene {
 public:
  /// Throws vug.Error with all faults of the text; warns of what is doubtful.
  Scene(std::string text, std::string file, LoadSettings settings);

  const loading::Loaded& loaded() const { return loaded_; }
  const shot::Shot& shot() const { return loaded_.shot; }
  const std::string& text() const { return text_; }
  const std::string& file() const { return file_; }
  const LoadSettings& settings() const { return settings_; }

  /// With all that stands still taken from other moments. Faults are in its diagnostics.
  loading::Loaded at(double frame) const;
  /// For PictureOptions::moment; any thread may call it while the scene lives.
  std::function<std::shared_ptr<const shot::Shot>(double)> shot_at_frame() const;

 private:
  std::string text_;
  std::string file_;
  LoadSettings settings_;
  mutable loading::StaticCache static_cache_;  ///< Of all its moments.
  mutable std::mutex load_mutex_;              ///< Guards that.
  loading::Loaded loaded_;
};
using ScenePtr = std::shared_ptr<const Scene>;

/// One of a scene's, which it keeps alive.
struct Derivation {
  ScenePtr scene;
  const shot::Derivation* derivation;

  const grammar::Tree& tree() const { return derivation->tree; }
};

/// The text after `-D NAME=` for a value from Python: numbers, truths, vectors; a str is text of
/// the scene language, a path becomes a text in quotes. TypeError, ValueError.
std::string override_text(const std::string& name, const py::handle& value);

/// None, number, bool, str, tuple of three numbers, or list of these; metres and radians.
py::object to_python(const Value& value);

}  // namespace vug::python

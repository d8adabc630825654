// SPDX-License-Identifier: Apache-2.0
// The display modes of a viewport, and their integrators.
#pragma once

#include <vug/render/integrator.h>

#include <string>
#include <vector>

namespace vug::viewport {

enum class Mode {
  clay,     ///< Grey surfaces, lit from the eye and by an even sky, which reaches into caves.
  normals,  ///< Shading normals as colours.
  ids,      ///< A colour for each object.
  path,     ///< The light and the materials of the scene.
};

/// "clay", "normals", "ids" and "path", in the order of the enumeration.
const std::vector<std::string>& mode_names();
/// Error(bad_input) with the known names.
Mode mode_of(const std::string& name);

/// The integrator of a mode, the same object at each call; null for Mode::path. It reads neither
/// lights nor materials nor the medium, so that a scene need not be prepared again for another
/// mode. `occlusion`: clay is darker in creases, which takes several samples.
render::IntegratorPtr preview_integrator(Mode mode, bool occlusion);

}  // namespace vug::viewport

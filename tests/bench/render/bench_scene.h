// SPDX-License-Identifier: Apache-2.0
// The reference caves: JSON with binary PLY files, so that other renderers can read them.
#pragma once

#include <vug/render/scene.h>

#include <filesystem>
#include <string>

namespace vug::bench {

/// `mesh_file` and `sky` ("r,g,b") replace those of the scene unless they are empty.
render::Scene read_scene(const std::filesystem::path& path, const std::string& mesh_file = "",
                         const std::string& sky = "", bool lamps = true, bool portals = false);

/// Adds this many small spheres of 20 W in total, anywhere in the box of the first object.
void add_lights(render::Scene& scene, int count);

}  // namespace vug::bench

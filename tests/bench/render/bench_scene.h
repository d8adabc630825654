// The reference caves: JSON beside binary PLY, so that other renderers can read them, too.
#pragma once

#include <vug/render/scene.h>

#include <filesystem>
#include <string>

namespace vug::bench {

/// `mesh_file` and `sky` ("r,g,b") replace the scene's when not empty.
render::Scene read_scene(const std::filesystem::path& path, const std::string& mesh_file = "",
                         const std::string& sky = "", bool lamps = true, bool portals = false);

/// So many small balls of together 20 W, anywhere in the box of the first object.
void add_lights(render::Scene& scene, int count);

}  // namespace vug::bench

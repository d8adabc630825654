// The files that a scene reads.
#pragma once

#include <vug/loading/load.h>

#include <filesystem>
#include <vector>

namespace vug::loading {

/// The scene's texts as far as they are files (what -D sets is none), and every file that a text in
/// quotes names, beside the text it stands in: meshes, grids, pictures; each once. Read from the
/// words, so it holds for scenes with faults, too, and for files that only another camera would
/// need; a name that is no file does not count.
std::vector<std::filesystem::path> file_dependencies(const Loaded& scene);

}  // namespace vug::loading

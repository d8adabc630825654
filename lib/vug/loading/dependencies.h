// SPDX-License-Identifier: Apache-2.0
// The files on which a scene depends.
#pragma once

#include <vug/loading/load.h>

#include <filesystem>
#include <vector>

namespace vug::loading {

/// The source files of the scene, every existing file named by a quoted string, relative to the
/// file that contains the string (meshes, grids, pictures), and the files of its networks, e.g. the
/// parts that a survey includes; each once. Overrides by -D are not files. The result comes from
/// the tokens, so it is valid for scenes with faults and includes files that only another camera
/// needs.
std::vector<std::filesystem::path> file_dependencies(const Loaded& scene);

}  // namespace vug::loading

// SPDX-License-Identifier: Apache-2.0
// The choice of render blocks, and the file names of several pictures.
#pragma once

#include <vug/shot/shot.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::picture {

/// Stands for all render blocks of a scene, unless one of them has this name.
inline constexpr const char* kAllRenders = "all";

/// The names of the render blocks to render, in the order of `wanted`, in which "all" stands for
/// every block in the order of the text. An empty list chooses the only block. Blocks of included
/// files only count if the scene's own text has none, or by name. A scene without blocks has one
/// picture with an empty name. Error(bad_input), which lists the blocks, if none of several is
/// chosen; with the nearest name for an unknown one.
std::vector<std::string> choose_renders(const shot::Shot& shot,
                                        const std::vector<std::string>& wanted);

/// The file of one of several pictures: NAME_RENDER.exr for NAME.exr. A placeholder for the frame
/// number at the end of NAME remains at the end: NAME_RENDER.####.exr.
std::filesystem::path path_of_render(const std::filesystem::path& path, const std::string& render);

}  // namespace vug::picture

// SPDX-License-Identifier: Apache-2.0
// Information stored in the comments of a mesh file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::mesh {

struct Comments {
  std::string space = "metres, y up";  ///< Unit and orientation of the coordinates.
  std::vector<std::pair<std::string, std::string>>
      texts;  ///< Name and text of each entry, as in all files written by Vug.
};

/// Returns one line for the space and lines for the texts, each preceded by `prefix` ("# ") and
/// limited to about 200 bytes whatever the texts contain, because readers have small buffers.
std::string comment_lines(const Comments& notes, std::string_view prefix);

/// Reads the texts back from the comments at the beginning of `bytes`. The result is empty for
/// files of other programs.
std::vector<std::pair<std::string, std::string>> read_comments(std::string_view bytes);

}  // namespace vug::mesh

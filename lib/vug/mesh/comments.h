// What a mesh file says beside the mesh, in its comments.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::mesh {

struct Comments {
  std::string space = "metres, y up";                      ///< What numbers mean.
  std::vector<std::pair<std::string, std::string>> texts;  ///< By name, as of any file of ours.
};

/// A line for the space and lines for the texts, each behind `prefix` ("# ") and of at most some
/// 200 bytes, whatever the texts hold: readers have narrow buffers.
std::string comment_lines(const Comments& notes, std::string_view prefix);

/// The texts again, of the comments at the beginning of a file in `bytes`; none in others' files.
std::vector<std::pair<std::string, std::string>> read_comments(std::string_view bytes);

}  // namespace vug::mesh

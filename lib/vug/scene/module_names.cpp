// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/module_names.h>

namespace vug::scene {

std::vector<std::string_view> split_names(std::string_view letters) {
  std::vector<std::string_view> out;
  for (size_t begin = 0, end; begin < letters.size(); begin = end) {
    for (end = begin + 1; end < letters.size() && !is_capital(letters[end]);) ++end;
    const std::string_view piece = letters.substr(begin, end - begin);
    const bool moves = piece.size() > 1 && (piece[0] == 'F' || piece[0] == 'f') &&
                       piece.find_first_not_of('f', 1) == std::string_view::npos;
    for (size_t i = 0; moves && i < piece.size(); ++i) out.push_back(piece.substr(i, 1));
    if (!moves) out.push_back(piece);
  }
  return out;
}

}  // namespace vug::scene

// SPDX-License-Identifier: Apache-2.0
// Names of modules in the words of L-systems.
#pragma once

#include <string_view>
#include <vector>

namespace vug::scene {

constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

/// Splits consecutive letters into names: each capital starts a name, so FFA is F F A and FlFr is
/// Fl Fr; Ff is F f (the turtle's commands), and ff is f f. The results are views of the text.
std::vector<std::string_view> split_names(std::string_view letters);

}  // namespace vug::scene

// Where a text's tokens are modules of an L-system: signs that have other meanings elsewhere.
#pragma once

#include <vug/scene/lexer.h>

#include <vector>

namespace vug::scene {

struct LSystemToken {
  bool inside = false;   ///< In the block of an L-system.
  bool module = false;   ///< A module of a head or a word, its parameters' brackets among it.
  bool goes_on = false;  ///< The first of a line that continues the one before.
};

/// One for each token of a text that was lexed with its comments.
std::vector<LSystemToken> mark_lsystems(const std::vector<Token>& tokens);

}  // namespace vug::scene

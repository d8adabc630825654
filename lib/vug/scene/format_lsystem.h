// SPDX-License-Identifier: Apache-2.0
// Classification of the tokens in L-system blocks, where signs are modules instead of operators.
#pragma once

#include <vug/scene/lexer.h>

#include <vector>

namespace vug::scene {

struct LSystemToken {
  bool inside = false;   ///< In the block of an L-system.
  bool module = false;   ///< Part of a module of a head or a word, including parameter brackets.
  bool goes_on = false;  ///< The first token of a continuation line.
};

/// Classifies each token of a text that was lexed with its comments.
std::vector<LSystemToken> mark_lsystems(const std::vector<Token>& tokens);

}  // namespace vug::scene

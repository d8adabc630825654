// SPDX-License-Identifier: Apache-2.0
// Signature help: the parameters of the call around a position.
#pragma once

#include <vug/language/workspace.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::language {

struct Signature {
  std::string label;
  std::string doc;
  struct Parameter {
    size_t begin = 0, end = 0;  ///< Bytes of its part of the label.
    std::string doc;
  };
  std::vector<Parameter> parameters;
  int active = -1;  ///< Index of the parameter at the position; -1: none.
};

/// The signatures of the innermost call, the most likely first; empty outside of calls.
std::vector<Signature> signatures_at(const Analysis& analysis, const Position& position);

}  // namespace vug::language

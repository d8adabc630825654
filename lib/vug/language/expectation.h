// SPDX-License-Identifier: Apache-2.0
// The kinds and parameters that a place in a text expects.
#pragma once

#include <vug/language/context.h>
#include <vug/language/kinds.h>
#include <vug/language/words.h>

#include <string>
#include <vector>

namespace vug::language {

/// What a call may mean: a function of the text, or kinds of several types.
struct CallMeaning {
  KindInfo info;
  std::string type;  ///< Type of the value; empty for functions.
  bool function = false;
};

/// The meanings of a call: the function of the text with that name, else those kinds that have all
/// of its named arguments (or all kinds, if none has); those of the expected type come first.
std::vector<CallMeaning> meanings_of(const OpenCall& call, const scene::Document& document,
                                     const std::string& expected = {});
/// The meanings of the innermost call.
std::vector<CallMeaning> meanings_at(const Context& context, const scene::Document& document);

/// The value that a place expects.
struct Expectation {
  std::string type;               ///< "field", "number", ...; empty: any.
  std::vector<ParamInfo> params;  ///< The parameters that it may be for; empty: none.
};
Expectation expectation_at(const Context& context, const scene::Document& document);

/// The parameters of the block around the position, without those that are given.
std::vector<ParamInfo> missing_entries(const Context& context, const scene::Document& document);

}  // namespace vug::language

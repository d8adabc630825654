// SPDX-License-Identifier: Apache-2.0
// Built-in functions of the scene language on numbers, vectors and lists.
#pragma once

#include <vug/base/schema.h>
#include <vug/scene/arithmetic.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::scene {

/// A built-in function; `takes` describes its arguments in words, for messages and lists.
struct Function {
  const char* name;
  const char* takes;
  const char* doc;
  /// Returns nothing if the arguments have other types. The call is then passed to the resolver, so
  /// that a kind may have the same name: round(2.4) is a function, round(10cm) a kind.
  std::optional<Value> (*apply)(const Arguments& arguments, const FaultSite& site);
  bool reads_elements = true;  ///< Takes time in proportion to the length of its lists.
};

const std::vector<Function>& functions();
const Function* find_function(const std::string& name);
/// The name of the function that other languages call `name`, for suggestions; else `name` itself.
std::string name_in_this_language(const std::string& name);

}  // namespace vug::scene

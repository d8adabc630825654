// SPDX-License-Identifier: Apache-2.0
// Readers of the arguments of built-in functions.
#pragma once

#include <vug/scene/functions.h>

#include <vector>

namespace vug::scene {

/// All arguments as numbers; empty if one has another type or a name.
inline std::vector<Number> numbers_of(const Arguments& arguments) {
  std::vector<Number> out;
  for (const Argument& argument : arguments) {
    const Number* n = argument.value.get<Number>();
    if (!n || !argument.name.empty()) return {};
    out.push_back(*n);
  }
  return out;
}

inline bool is_plain(const Number& n) { return is_plain(n.dimension); }

inline bool is_angle(const Number& n) {
  return n.dimension == Dimension::angle || (n.dimension == Dimension::none && n.value == 0);
}

/// The list at a position; null if the argument has another type or a name, or is missing.
inline const List* list_at(const Arguments& arguments, size_t index) {
  return index < arguments.size() && arguments[index].name.empty()
             ? arguments[index].value.get<List>()
             : nullptr;
}

/// Gives all numbers the same dimension; returns false after an error.
bool unify_all_dimensions(std::vector<Number>& all, const FaultSite& site);

}  // namespace vug::scene

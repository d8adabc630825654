// SPDX-License-Identifier: Apache-2.0
// Local names of functions, rules and loops.
#pragma once

#include <vug/base/rng.h>
#include <vug/scene/document.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vug::scene {

/// A name with its value, such as a formal parameter.
struct Binding {
  Binding(std::string bound, Value given, int nesting = 0)
      : name(std::move(bound)), value(std::move(given)), height(nesting) {}

  std::string name;
  Value value;
  int height;  ///< Nesting depth of the calls that made the value; 0 for a number or a text.
};

/// The names that `where` declares, evaluated on first use. `key` determines their random choices.
struct Locals {
  explicit Locals(const std::vector<Let>& declared, RandomKey random)
      : lets(declared), key(random) {}

  const std::vector<Let>& lets;
  RandomKey key;
  std::map<std::string, Binding> values;  ///< Those that have been used.
  std::vector<std::string> pending;       ///< Those that are being evaluated.
};

/// Local names; an inner scope hides an outer one.
struct Scope {
  std::vector<Binding> names;
  const Scope* outer = nullptr;
  Locals* locals = nullptr;  ///< Null: no `where`. Their values see all names of this scope.
};

}  // namespace vug::scene

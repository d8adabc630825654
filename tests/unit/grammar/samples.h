// SPDX-License-Identifier: Apache-2.0
// Small grammars shared by several tests.
#pragma once

#include <vug/grammar/derive.h>

namespace vug::grammar {

inline double number(const RewriteSite& site, size_t i = 0) {
  return site.symbol.content.params.at(i).get<Number>()->value;
}

/// Items with constant content.
inline SuccessorItem part(std::string symbol, int64_t count = 1) {
  SuccessorItem p;
  p.symbol = std::move(symbol);
  p.count = [count](const RewriteSite&) { return count; };
  return p;
}
inline SuccessorItem terminal(std::string symbol, int64_t count = 1) {
  SuccessorItem p = part(std::move(symbol), count);
  p.terminal = true;
  return p;
}
/// An item with one computed parameter.
inline SuccessorItem computed(std::string symbol, std::function<double(const RewriteSite&)> value) {
  SuccessorItem p = part(std::move(symbol));
  p.content = [value = std::move(value)](const RewriteSite& site) {
    return Content{{Value(value(site))}, {}, ""};
  };
  return p;
}
inline Production rule(std::string symbol, std::vector<SuccessorItem> parts, double weight = 1) {
  Production p;
  p.symbol = std::move(symbol);
  p.successor = std::move(parts);
  p.weight = [weight](const RewriteSite&) { return weight; };
  return p;
}

/// A branch divides into two to four with random sizes until they are small: random in choice,
/// parameters and counts.
inline Grammar shrub() {
  const auto smaller = [](const RewriteSite& s) {
    return number(s) * RandomStream(s.key).uniform(0.4, 0.8);
  };
  Grammar g;
  g.name = "shrub";
  g.axiom = {computed("Branch", [](const RewriteSite&) { return 1.0; })};
  SuccessorItem some = computed("Branch", smaller);
  some.count = [](const RewriteSite& s) { return int64_t{1} + RandomStream(s.key).below(3); };
  Production fork = rule("Branch", {some, computed("Branch", smaller)}, 2);
  fork.guard = [](const RewriteSite& s) { return number(s) > 0.15; };
  Production stop = rule("Branch", {terminal("leaf")});
  g.productions = {fork, stop};
  return g;
}

/// The names of the derived word, separated by spaces.
inline std::string word(const Tree& tree) {
  std::string out;
  for (const int leaf : tree.leaves()) {
    if (!out.empty()) out += ' ';
    out += to_string(tree.nodes[static_cast<size_t>(leaf)].symbol);
  }
  return out;
}

}  // namespace vug::grammar

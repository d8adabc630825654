// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/wrap_rule.h>

#include <vector>

namespace vug::facade {
namespace {

constexpr size_t kIndent = 2;

/// A comma after which the line may be broken.
struct Break {
  size_t after = 0;  ///< Position of the space behind the comma.
  size_t depth = 0;  ///< Number of open brackets.
  bool before_size = false;
};

bool better(const Break& a, const Break& b) {
  if (a.depth != b.depth) return a.depth < b.depth;
  return a.before_size >= b.before_size;  // The later one of equals.
}

}  // namespace

std::string wrap_rule(const std::string& rule, size_t columns) {
  std::string out;
  std::vector<size_t> open;  // Indents of the lines with the open brackets.
  size_t begin = 0, indent = kIndent;
  while (begin < rule.size()) {
    std::vector<size_t> inner = open;
    std::vector<Break> breaks;
    size_t at = begin;
    for (; at < rule.size() && (indent + at - begin < columns || breaks.empty()); ++at) {
      if (rule[at] == '(' || rule[at] == '[') inner.push_back(indent);
      if (rule[at] == ')' || rule[at] == ']') inner.pop_back();
      if (rule[at] == ',' && !inner.empty() && at + 2 < rule.size()) {
        const bool digit = rule[at + 2] >= '0' && rule[at + 2] <= '9';
        breaks.push_back({at + 1, inner.size(), digit});
      }
    }
    size_t end = rule.size();
    if (at < rule.size()) {
      Break best = breaks.front();
      for (const Break& each : breaks)
        if (better(each, best)) best = each;
      end = best.after;
    }
    out += (out.empty() ? "" : "\n") + std::string(indent, ' ') + rule.substr(begin, end - begin);
    for (size_t i = begin; i < end; ++i) {
      if (rule[i] == '(' || rule[i] == '[') open.push_back(indent);
      if (rule[i] == ')' || rule[i] == ']') open.pop_back();
    }
    begin = end < rule.size() ? end + 1 : end;
    indent = open.empty() ? kIndent : open.back() + kIndent;
  }
  return out;
}

}  // namespace vug::facade

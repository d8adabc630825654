// SPDX-License-Identifier: Apache-2.0
// Paths of nodes, with child indices or names.
#include <vug/base/diagnostics.h>
#include <vug/modeller/facade_state.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vug::modeller {

namespace {

/// One step of a path: an index, or a name with an index in brackets.
struct PathStep {
  std::string name;  ///< Empty: the index counts all children.
  std::vector<int> numbers;
};

/// Comma-separated non-negative integers; empty for anything else.
std::vector<int> numbers_of(std::string_view text) {
  std::vector<int> out;
  while (true) {
    int number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || number < 0) return {};
    out.push_back(number);
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    if (text.empty()) return out;
    if (text[0] != ',') return {};
    text.remove_prefix(1);
  }
}

PathStep read_step(const std::string& text) {
  PathStep out;
  out.numbers = numbers_of(text);
  if (out.numbers.size() == 1) return out;
  const size_t open = text.find('[');
  out.name = text.substr(0, open);
  out.numbers = {0};
  if (open == std::string::npos && !text.empty()) return out;
  out.numbers.clear();
  if (open != std::string::npos && text.back() == ']')
    out.numbers = numbers_of(std::string_view(text).substr(open + 1, text.size() - open - 2));
  if (out.name.empty() || out.numbers.empty() || out.numbers.size() > 2)
    throw Error(ErrorCode::bad_input, fmt::format("invalid step '{}' of a path", text), {},
                "such as 0, Grid, window[3], or window[2,1]");
  return out;
}

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> out(1);
  int depth = 0;
  for (const char c : path) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == '.' && depth == 0)
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

}  // namespace

int FacadeState::find(const std::string& path) const {
  if (path == ".") return kWhole;
  int at = kWhole;
  for (const std::string& text : steps_of(path)) {
    const PathStep step = read_step(text);
    std::vector<int> named;
    std::vector<std::string> names;
    const std::vector<int> parts = this->parts(at);
    for (const int part : parts) {
      names.push_back(node(part).symbol);
      if (step.name.empty() || node(part).symbol == step.name) named.push_back(part);
    }
    int found = kWhole;
    for (size_t i = 0; i < named.size(); ++i) {
      const facade::PartKey& place = planned(named[i]).place;
      if (step.numbers.size() == 1
              ? static_cast<int>(i) == step.numbers[0]
              : place.column == step.numbers[0] && place.row == step.numbers[1])
        found = named[i];
    }
    if (found == kWhole) {
      const std::string whose =
          at == kWhole ? "the facade" : fmt::format("'{}' at {}", node(at).symbol, this->path(at));
      std::string hint = parts.empty() ? "no rule divides it yet"
                         : step.name.empty() || !named.empty()
                             ? fmt::format("it has {} of them, counted from 0", named.size())
                             : suggestion(step.name, names);
      if (at != kWhole && node(at).element) hint = "it is an element";
      throw Error(ErrorCode::bad_input, fmt::format("{} has no part '{}'", whose, text), {}, hint);
    }
    at = found;
  }
  return at;
}

std::string FacadeState::path(int index) const {
  std::string out;
  for (int at = index; at >= 0; at = node(at).parent) {
    const std::vector<int> all = parts(node(at).parent);
    const auto number = std::find(all.begin(), all.end(), at) - all.begin();
    out = fmt::format("{}{}{}", number, out.empty() ? "" : ".", out);
  }
  return out.empty() ? "." : out;
}

}  // namespace vug::modeller

// SPDX-License-Identifier: Apache-2.0
// Parsing and formatting of edits as lines of text.
#include <vug/modeller/edit.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace vug::modeller {

namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == at)
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

double read_number(const std::string& name, const std::string& text, double metres_per_pixel) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string unit(end, text.data() + text.size());
  if (fault != std::errc() || !std::isfinite(value))
    throw edit_error(fmt::format("invalid number '{}={}'", name, text),
                     "such as 4, 2.4m, 90cm, 120px");
  if (unit.empty() || unit == "m") return value;
  if (unit == "cm") return value / 100;
  if (unit != "px") throw edit_error(fmt::format("unknown unit '{}'", unit), "use m, cm or px");
  if (!(metres_per_pixel > 0))
    throw edit_error(fmt::format("'{}={}': the pixel size is unknown", name, text),
                     "the session has no photo with a scale");
  return value * metres_per_pixel;
}

/// Position where the " name=" arguments begin, or the end.
size_t numbers_at(const std::string& text) {
  for (size_t i = 0; i < text.size(); ++i) {
    if (i > 0 && text[i - 1] != ' ') continue;
    size_t end = i;
    const auto in_name = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    };
    while (end < text.size() && in_name(text[end])) ++end;
    if (end > i && end < text.size() && text[end] == '=') return i;
  }
  return text.size();
}

std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Removes and returns the first word of the text.
std::string take_word(std::string& text) {
  text = trimmed(text);
  const size_t end = text.find(' ');
  std::string out = text.substr(0, end);
  text = end == std::string::npos ? "" : text.substr(end + 1);
  return out;
}

}  // namespace

Edit parse_edit(const std::string& text, const std::string& kind, double metres_per_pixel) {
  std::string rest = text;
  Edit out;
  out.kind = kind.empty() ? take_word(rest) : kind;
  const EditKind& found = edit_kind(out.kind);
  out.node = take_word(rest);
  if (out.node.empty())
    throw edit_error(fmt::format("'{}' needs a node", out.kind), "such as 0, 0.1, or .");
  const size_t numbers = numbers_at(rest);
  out.rule = trimmed(rest.substr(0, numbers));
  if (!found.rule && !out.rule.empty())
    throw edit_error(fmt::format("'{}' takes numbers as name=value, not '{}'", out.kind, out.rule));
  for (const std::string& word : split(rest.substr(numbers), ' ')) {
    if (word.empty()) continue;
    const size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw edit_error(fmt::format("'{}' is not a number of an edit", word),
                       "such as columns=4, or dx=2.1,2.4");
    const std::string name = word.substr(0, equals), values = word.substr(equals + 1);
    std::vector<double>& list = out.numbers[name];
    if (!list.empty()) throw edit_error(fmt::format("'{}' is given twice", name));
    if (values.empty()) continue;
    for (const std::string& value : split(values, ','))
      list.push_back(read_number(name, value, metres_per_pixel));
  }
  return out;
}

std::string to_string(const Edit& edit) {
  std::string out = fmt::format("{} {}", edit.kind, edit.node);
  if (!edit.rule.empty()) out += ' ' + edit.rule;
  for (const auto& [name, values] : edit.numbers) {
    out += fmt::format(" {}=", name);
    for (size_t i = 0; i < values.size(); ++i) out += fmt::format("{}{}", i ? "," : "", values[i]);
  }
  return out;
}

}  // namespace vug::modeller

// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/json_file.h>
#include <vug/base/json_value.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug {
namespace {

using Json = nlohmann::ordered_json;

/// Scans a text that is known to be valid JSON.
class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  /// Moves to the value of a key; false if it does not exist.
  bool enter(const std::string& key) {
    skip_space();
    const char open = peek();
    if (open != '{' && open != '[') return false;
    ++at_;
    for (size_t number = 0;; ++number) {
      skip_space();
      if (peek() == '}' || peek() == ']' || at_ >= text_.size()) return false;
      std::string name = fmt::format("{}", number);
      if (open == '{') {
        const size_t begin = at_;
        skip_text();
        name = Json::parse(text_.substr(begin, at_ - begin), nullptr, false).get<std::string>();
        skip_space();
        ++at_;  // Skips the colon.
        skip_space();
      }
      if (name == key) return true;
      skip_value();
      skip_space();
      if (peek() == ',') ++at_;
    }
  }

  size_t at() {
    skip_space();
    return at_;
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string::npos)
      ++at_;
  }
  void skip_text() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    ++at_;
  }
  void skip_value() {
    int depth = 0;
    do {
      const char c = peek();
      if (c == '"') {
        skip_text();
        continue;
      }
      depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
      ++at_;
      // A number or a word ends before the next separator.
    } while (at_ < text_.size() &&
             (depth > 0 || std::string_view(",]} \t\r\n").find(text_[at_]) == std::string::npos));
  }

  const std::string& text_;
  size_t at_ = 0;
};

/// Position of a value in a valid JSON text. The path holds keys and element indices.
SourceLocation locate(const std::string& text, const std::string& file,
                      const std::vector<std::string>& path) {
  Scanner scanner(text);
  size_t at = scanner.at();
  for (const std::string& key : path) {
    if (!scanner.enter(key)) break;
    at = scanner.at();
  }
  return location_in(text, file, at);
}

}  // namespace

Json JsonValue::parse(const std::string& text, const std::string& file) {
  std::vector<std::set<std::string>> keys;
  std::string twice;
  const auto see = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      twice = parsed.get<std::string>();
    return true;
  };
  try {
    Json out = Json::parse(text, see);
    if (!twice.empty())
      throw Error(ErrorCode::bad_input, fmt::format("duplicate key '{}' in one object", twice),
                  location_in(text, file, text.rfind('"' + twice + '"')));
    return out;
  } catch (const Json::parse_error& error) {
    throw Error(ErrorCode::bad_input, "invalid JSON",
                location_in(text, file, error.byte == 0 ? 0 : error.byte - 1));
  } catch (const Json::exception&) {
    throw Error(ErrorCode::bad_input, "invalid JSON: a number is too large", {file, 0, 0});
  }
}

JsonValue::JsonValue(const JsonValue& above, const Json& value, const std::string& key)
    : value_(&value), text_(above.text_), file_(above.file_), path_(above.path_) {
  path_.push_back(key);
}

bool JsonValue::has(const std::string& key) const {
  return value_->is_object() && value_->contains(key);
}

JsonValue JsonValue::at(const std::string& key) const {
  if (!has(key)) throw fault(fmt::format("'{}' is missing", key));
  return {*this, (*value_)[key], key};
}

std::vector<JsonValue> JsonValue::items() const {
  check_array();
  std::vector<JsonValue> out;
  for (size_t i = 0; i < value_->size(); ++i)
    out.push_back({*this, (*value_)[i], fmt::format("{}", i)});
  return out;
}

std::string JsonValue::text() const {
  if (!value_->is_string()) throw fault("expected a string");
  return value_->get<std::string>();
}

double JsonValue::number() const {
  if (!value_->is_number()) throw fault("expected a number");
  const double out = value_->get<double>();
  if (!std::isfinite(out)) throw fault("the number must be finite");
  return out;
}

uint64_t JsonValue::unsigned_integer() const {
  const double out = number();
  if (!(out >= 0 && out <= 9007199254740992.0) || out != std::floor(out))
    throw fault("expected a non-negative integer");
  return static_cast<uint64_t>(out);
}

void JsonValue::check_array() const {
  if (!value_->is_array()) throw fault("expected a list");
}

void JsonValue::check_object() const {
  if (!value_->is_object()) throw fault("expected an object");
}

void JsonValue::check_object(const std::vector<std::string>& known) const {
  check_object();
  for (const auto& [key, value] : value_->items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw fault(fmt::format("unknown key '{}'", key), suggestion(key, known), key);
}

Error JsonValue::fault(const std::string& message, const std::string& hint,
                       const std::string& below) const {
  std::vector<std::string> path = path_;
  const Json* value = value_;
  for (size_t at = 0; at < below.size();) {
    const size_t end = std::min(below.find('/', at), below.size());
    const std::string key = below.substr(at, end - at);
    if (!value->is_object() || !value->contains(key)) break;
    value = &(*value)[key];
    path.push_back(key);
    at = end + 1;
  }
  std::string pointer;
  for (const std::string& key : path) pointer += '/' + key;
  return Error(ErrorCode::bad_input, (pointer.empty() ? "" : pointer + ": ") + message,
               locate(*text_, *file_, path), hint);
}

}  // namespace vug

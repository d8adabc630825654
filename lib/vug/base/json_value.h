// SPDX-License-Identifier: Apache-2.0
// JSON values with their positions in the text, for errors that name the line of a value.
#pragma once

#include <vug/base/error.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace vug {

/// A JSON value and its pointer: "/edits/3/numbers/rows".
class JsonValue {
 public:
  /// Parses a whole text; text and file name must outlive the values. Error(bad_input) with line
  /// and column for invalid JSON and for a duplicate key.
  static nlohmann::ordered_json parse(const std::string& text, const std::string& file);
  JsonValue(const nlohmann::ordered_json& value, const std::string& text, const std::string& file)
      : value_(&value), text_(&text), file_(&file) {}

  const nlohmann::ordered_json& json() const { return *value_; }
  bool has(const std::string& key) const;
  /// Error(bad_input) if the key is missing.
  JsonValue at(const std::string& key) const;
  std::vector<JsonValue> items() const;  ///< Elements of an array.

  /// Error(bad_input) if the value has another type or is not finite.
  std::string text() const;
  double number() const;
  /// At most 2^53.
  uint64_t unsigned_integer() const;
  void check_array() const;
  /// Requires an object with no other keys than these.
  void check_object(const std::vector<std::string>& known) const;
  void check_object() const;

  /// An error located at this value, or at one below it: "rule", "numbers/rows". If that does not
  /// exist, the location is its nearest ancestor.
  Error fault(const std::string& message, const std::string& hint = {},
              const std::string& below = {}) const;

 private:
  JsonValue(const JsonValue& above, const nlohmann::ordered_json& value, const std::string& key);

  const nlohmann::ordered_json* value_;
  const std::string* text_;
  const std::string* file_;
  std::vector<std::string> path_;
};

}  // namespace vug

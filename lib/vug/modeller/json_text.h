// Inside modeller/ only: a JSON text whose values know where they stand.
#pragma once

#include <vug/base/error.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace vug::modeller {

using Json = nlohmann::ordered_json;

/// A value of a text, and its pointer: "/edits/3/numbers/rows".
class JsonValue {
 public:
  /// The whole of a text; both must outlive it. Error(bad_input) with line and column for what is
  /// no JSON, and for a key that stands twice in one object.
  static Json parse(const std::string& text, const std::string& file);
  JsonValue(const Json& value, const std::string& text, const std::string& file)
      : value_(&value), text_(&text), file_(&file) {}

  const Json& json() const { return *value_; }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  /// Error(bad_input) where it is missing.
  JsonValue at(const std::string& key) const;
  std::vector<JsonValue> items() const;  ///< Of an array.

  /// Error(bad_input) where it is something else, or not finite.
  std::string text() const;
  double number() const;
  /// At most 2^53.
  uint64_t whole() const;
  void check_array() const;
  /// An object with no keys but these.
  void check_object(const std::vector<std::string>& known) const;
  void check_object() const;

  /// What is wrong with the value, or with one below it: "rule", "numbers/rows". Where there is
  /// nothing at the key, with what is nearest above it.
  Error fault(const std::string& message, const std::string& hint = {},
              const std::string& below = {}) const;

 private:
  JsonValue(const JsonValue& above, const Json& value, const std::string& key);

  const Json* value_;
  const std::string* text_;
  const std::string* file_;
  std::vector<std::string> path_;
};

/// Where the value at the end of the way begins in a text that is JSON; keys, and numbers of
/// elements.
SourceLocation locate(const std::string& text, const std::string& file,
                      const std::vector<std::string>& path);

}  // namespace vug::modeller

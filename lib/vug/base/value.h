// SPDX-License-Identifier: Apache-2.0
// Values of scene expressions, before they are bound to a kind's parameters.
#pragma once

#include <vug/base/dimension.h>
#include <vug/base/vec.h>

#include <any>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace vug {

/// A value as scene text with six digits: "30deg", "52%", "0.25m"; 0 has no unit.
std::string quantity_text(double value, Dimension dimension);
/// The same with all digits, for numbers that are nearly equal.
std::string exact_quantity_text(double value, Dimension dimension);

struct Number {
  double value = 0;
  Dimension dimension = Dimension::none;
};

/// A kind's product (a field, a light, ...), passed through expressions unchanged.
struct Object {
  std::string type;  ///< Name of the type in messages, e.g. "field", "noise", "blend".
  std::any data;
};

class Value;
using List = std::vector<Value>;

/// A number, vector of three numbers, text, boolean, bare name (an enumerator), list or object.
class Value {
 public:
  struct Name {
    std::string text;
  };
  struct Vector {
    Vec3d value;
    Dimension dimension = Dimension::none;
  };
  Value() = default;
  Value(double number) : data_(Number{number}) {}                    // NOLINT
  Value(int number) : data_(Number{static_cast<double>(number)}) {}  // NOLINT
  Value(Number number) : data_(number) {}                            // NOLINT
  Value(const Vec3d& vector) : data_(Vector{vector}) {}              // NOLINT
  Value(Vector vector) : data_(vector) {}                            // NOLINT
  Value(bool truth) : data_(truth) {}                                // NOLINT
  Value(const char* text) : Value(std::string(text)) {}              // NOLINT
  Value(std::string text);                                           // NOLINT
  Value(Name name) : data_(std::move(name)) {}                       // NOLINT
  Value(List list);                                                  // NOLINT
  Value(Object object) : data_(std::move(object)) {}                 // NOLINT

  template <class T>
  const T* get() const {
    if constexpr (std::is_same_v<T, List>) {
      return list();
    } else if constexpr (std::is_same_v<T, std::string>) {
      const auto* text = std::get_if<std::shared_ptr<const std::string>>(&data_);
      return text ? text->get() : nullptr;
    } else {
      return std::get_if<T>(&data_);
    }
  }
  /// The object's data as T, or null if this is not an object of that C++ type.
  template <class T>
  const T* object() const {
    const Object* o = get<Object>();
    return o ? std::any_cast<T>(&o->data) : nullptr;
  }
  /// The number of elements of a list, including those of nested lists; 1 for other values.
  size_t element_count() const;
  bool empty() const { return std::holds_alternative<std::monostate>(data_); }
  /// The type with its article, for messages: "a number", "a vector", "a field", ...
  std::string type_name() const;

 private:
  struct ListData;
  const List* list() const;

  // Copies share lists and texts, so that a long one costs no more than a number.
  std::variant<std::monostate, Number, Vector, bool, std::shared_ptr<const std::string>, Name,
               std::shared_ptr<const ListData>, Object>
      data_;
};

/// The value as scene text; numbers are in the shortest form that parses to the same value.
std::string to_string(const Value& value);

/// The number for readers: as to_string, but with angles in degrees and ratios in percent unless
/// these have more than 15 digits.
std::string shortest_text(const Number& number);

}  // namespace vug

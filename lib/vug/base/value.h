// What an expression of a scene evaluates to, before a kind's parameters take it.
#pragma once

#include <vug/base/vec.h>

#include <any>
#include <string>
#include <variant>
#include <vector>

namespace vug {

/// What a number measures. Text may carry a unit; inside, lengths are metres and angles radians.
enum class Dimension { none, length, angle, ratio, per_length, time };

std::string to_string(Dimension dimension);  ///< "length in metres", "angle", ...

/// A value as people write it, to six digits: "30deg", "52%", "0.25m"; 0 without a unit.
std::string quantity_text(double value, Dimension dimension);

struct Number {
  double value = 0;
  Dimension dimension = Dimension::none;
};

/// A kind's product (a field, a light, ...) carried through expressions untouched.
struct Object {
  std::string type;  ///< e.g. "field", "noise", "blend": what messages call it.
  std::any data;
};

class Value;
using List = std::vector<Value>;

/// Number, vector of three numbers, text, truth, bare name (an enumerator), list or object.
class Value {
 public:
  struct Name {
    std::string text;
  };
  struct Vector {
    Vec3d value;
    Dimension dimension = Dimension::none;
  };
  using Data = std::variant<std::monostate, Number, Vector, bool, std::string, Name, List, Object>;

  Value() = default;
  Value(double number) : data_(Number{number}) {}                    // NOLINT
  Value(int number) : data_(Number{static_cast<double>(number)}) {}  // NOLINT
  Value(Number number) : data_(number) {}                            // NOLINT
  Value(const Vec3d& vector) : data_(Vector{vector}) {}              // NOLINT
  Value(Vector vector) : data_(vector) {}                            // NOLINT
  Value(bool truth) : data_(truth) {}                                // NOLINT
  Value(const char* text) : data_(std::string(text)) {}              // NOLINT
  Value(std::string text) : data_(std::move(text)) {}                // NOLINT
  Value(Name name) : data_(std::move(name)) {}                       // NOLINT
  Value(List list) : data_(std::move(list)) {}                       // NOLINT
  Value(Object object) : data_(std::move(object)) {}                 // NOLINT

  template <class T>
  const T* get() const {
    return std::get_if<T>(&data_);
  }
  /// The object's data as T, or null when this is no object of that C++ type.
  template <class T>
  const T* object() const {
    const Object* o = get<Object>();
    return o ? std::any_cast<T>(&o->data) : nullptr;
  }
  bool empty() const { return std::holds_alternative<std::monostate>(data_); }
  /// "a number", "a vector", "a field", ...: for messages.
  std::string type_name() const;

 private:
  Data data_;
};

/// How the value reads in a scene text; numbers in the shortest form that reads back the same.
std::string to_string(const Value& value);

}  // namespace vug

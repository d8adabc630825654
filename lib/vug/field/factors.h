// SPDX-License-Identifier: Apache-2.0
// A parameter that is one number or a vector of three: scale factors, noise scales.
#pragma once

#include <vug/base/schema.h>

namespace vug::field {

struct Factors {
  Vec3d each{1, 1, 1};
};

}  // namespace vug::field

namespace vug {

template <>
struct ValueTraits<field::Factors> {
  static std::string type() { return "number or vector"; }
  static std::optional<field::Factors> read(const Value& v) {
    if (const auto* vector = v.get<Value::Vector>()) return field::Factors{vector->value};
    if (const auto* number = v.get<Number>()) return field::Factors{Vec3d(number->value)};
    return std::nullopt;
  }
  static Value write(const field::Factors& f) {
    return f.each == Vec3d(f.each.x) ? Value(f.each.x) : Value(f.each);
  }
};

}  // namespace vug

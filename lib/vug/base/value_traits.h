// SPDX-License-Identifier: Apache-2.0
// Conversion between Values and the members of a parameter struct.
#pragma once

#include <vug/base/value.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Converts one Value to a member's type and back. Modules specialise it for their objects.
/// `type()` is the name of the expected type; `read` returns nothing for a value of another type.
template <class T>
struct ValueTraits;

/// Base of the ValueTraits of a kind's product, which values store as an Object. A specialisation
/// defines the name of the type:
///   template <> struct ValueTraits<LightPtr> : ObjectTraits<LightPtr> {
///     static constexpr const char* kWord = "light";
///   };
template <class T>
struct ObjectTraits {
  static std::string type() { return ValueTraits<T>::kWord; }
  static std::optional<T> read(const Value& v) {
    const T* object = v.object<T>();
    return object ? std::optional(*object) : std::nullopt;
  }
  static Value write(const T& object) {
    if constexpr (requires { object == nullptr; })
      if (object == nullptr) return {};
    return Object{type(), object};
  }
};

template <>
struct ValueTraits<double> {
  static std::string type() { return "number"; }
  static std::optional<double> read(const Value& v) {
    const Number* n = v.get<Number>();
    return n ? std::optional(n->value) : std::nullopt;
  }
  static Value write(double v) { return v; }
};

template <>
struct ValueTraits<int> {
  static std::string type() { return "whole number"; }
  static std::optional<int> read(const Value& v) {
    const Number* n = v.get<Number>();
    if (!n || n->value != std::floor(n->value) || std::fabs(n->value) > 2147483647)
      return std::nullopt;
    return static_cast<int>(n->value);
  }
  static Value write(int v) { return v; }
};

template <>
struct ValueTraits<bool> {
  static std::string type() { return "true or false"; }
  static std::optional<bool> read(const Value& v) {
    const bool* b = v.get<bool>();
    return b ? std::optional(*b) : std::nullopt;
  }
  static Value write(bool v) { return v; }
};

template <>
struct ValueTraits<std::string> {
  static std::string type() { return "text"; }
  static std::optional<std::string> read(const Value& v) {
    const std::string* s = v.get<std::string>();
    return s ? std::optional(*s) : std::nullopt;
  }
  static Value write(const std::string& v) { return v; }
};

template <>
struct ValueTraits<std::filesystem::path> {
  static std::string type() { return "file"; }
  static Value write(const std::filesystem::path& v) { return v.string(); }
};

template <>
struct ValueTraits<Vec3d> {
  static std::string type() { return "vector"; }
  static std::optional<Vec3d> read(const Value& v) {
    const auto* vector = v.get<Value::Vector>();
    return vector ? std::optional(vector->value) : std::nullopt;
  }
  static Value write(const Vec3d& v) { return v; }
};

template <class T>
struct ValueTraits<std::optional<T>> {
  static std::string type() { return ValueTraits<T>::type(); }
  static std::optional<std::optional<T>> read(const Value& v) {
    const std::optional<T> inner = ValueTraits<T>::read(v);
    if (!inner) return std::nullopt;
    return std::optional<std::optional<T>>(std::in_place, inner);
  }
  static Value write(const std::optional<T>& v) { return v ? ValueTraits<T>::write(*v) : Value(); }
};

/// Reads a list value; a single element is read as a list of one.
template <class T>
struct ValueTraits<std::vector<T>> {
  static std::string type() { return "list of " + ValueTraits<T>::type(); }
  static std::optional<std::vector<T>> read(const Value& v) {
    std::vector<T> out;
    if (const List* list = v.get<List>()) {
      for (const Value& item : *list) {
        auto element = ValueTraits<T>::read(item);
        if (!element) return std::nullopt;
        out.push_back(std::move(*element));
      }
      return out;
    }
    auto element = ValueTraits<T>::read(v);
    if (!element) return std::nullopt;
    out.push_back(std::move(*element));
    return out;
  }
  static Value write(const std::vector<T>& v) {
    List list;
    for (const T& item : v) list.push_back(ValueTraits<T>::write(item));
    return list;
  }
};

}  // namespace vug

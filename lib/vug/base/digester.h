// SPDX-License-Identifier: Apache-2.0
// Digests of data structures: every member of a value contributes, and a type without a rule does
// not compile.
#pragma once

#include <vug/base/aggregate.h>
#include <vug/base/hash.h>
#include <vug/base/interval.h>
#include <vug/base/vec.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace vug {

class Digester;

/// Types with their own rule: `void add_to(Digester&) const`, which adds all members.
template <class T>
concept AddsToDigest = requires(const T& value, Digester& digester) {
  value.add_to(digester);
};

/// Types that know their digest: `Digest digest() const`.
template <class T>
concept HasDigest = requires(const T& value) {
  { value.digest() } -> std::convertible_to<Digest>;
};

/// Computes the digest of values from their exact bits. Numbers, texts, vectors, boxes, ranges,
/// pointers (by what they point to), optional and variant values have rules; a struct of such
/// values needs none, because all of its members are added. Other classes have a member function
/// `add_to` or `digest`.
///   Digester()(radius, points, material).finish()
class Digester {
 public:
  template <class... T>
  Digester& operator()(const T&... values) {
    (add(values), ...);
    return *this;
  }
  Digest finish() const { return hasher_.finish(); }

 private:
  template <class T>
  void add(const T& v) {
    if constexpr (HasDigest<T>)
      add_bytes(v.digest());
    else if constexpr (AddsToDigest<T>)
      v.add_to(*this);
    else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Digest>)
      add_bytes(v);
    else if constexpr (std::is_convertible_v<const T&, std::string_view>)
      hasher_.add(std::string_view(v));
    else if constexpr (std::is_same_v<T, std::filesystem::path>)
      hasher_.add(v.generic_string());
    else if constexpr (std::is_same_v<T, std::monostate>)
      add_bytes('\0');
    else if constexpr (requires { v.min.x, v.max.x; })  // Boxes.
      (*this)(v.min, v.max);
    else if constexpr (requires { v.x, v.y, v.z; })
      (*this)(v.x, v.y, v.z);
    else if constexpr (requires { v.x, v.y; })
      (*this)(v.x, v.y);
    else if constexpr (std::is_same_v<T, Interval>)
      (*this)(v.lo, v.hi);
    else if constexpr (requires { v.begin(), v.end(), v.size(); })
      add_range(v);
    else if constexpr (requires { v.valueless_by_exception(); })
      add_bytes(v.index()), std::visit([&](const auto& each) { add(each); }, v);
    else if constexpr (requires { v ? *v : *v; })  // Pointers and optional values.
      add_bytes(static_cast<bool>(v)), v ? add(*v) : void();
    else if constexpr (requires { v.first, v.second; })
      (*this)(v.first, v.second);
    else {
      static_assert(
          std::is_aggregate_v<T>,
          "add a member 'void add_to(Digester&) const' to the type that adds its members");
      visit_members(v, *this);
    }
  }
  template <class Range>
  void add_range(const Range& range) {
    add_bytes(static_cast<uint64_t>(range.size()));
    using T = std::decay_t<decltype(*range.begin())>;
    if constexpr ((std::is_arithmetic_v<T> && requires { range.data(); }))
      hasher_.add(range.data(), range.size() * sizeof(T));
    else
      for (const auto& each : range) add(each);
  }
  template <class T>
  void add_bytes(const T& value) {
    hasher_.add_value(value);
  }

  Hasher hasher_;
};

/// The digest of some values; see Digester.
template <class... T>
Digest digest_of(const T&... values) {
  return Digester()(values...).finish();
}

}  // namespace vug

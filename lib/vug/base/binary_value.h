// SPDX-License-Identifier: Apache-2.0
// Plain values in binary streams: numbers, vectors, texts, lists, optional values, and structs of
// them, for files that only this machine reads again.
#pragma once

#include <vug/base/aggregate.h>
#include <vug/base/binary_stream.h>

#include <optional>

namespace vug {

namespace detail {

template <class T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class T>
concept PlainVector = requires(const T& v) {
  v.x, v.y;
};
template <class T>
concept PlainList = requires(const T& v) {
  v.size(), v.capacity();
};
template <class T>
concept PlainOptional = requires(const T& v) {
  v.has_value();
};

}  // namespace detail

/// Writes a value. A struct is written as all of its members, so a new member changes the file.
template <class T>
void write_value(std::ostream& out, const T& value) {
  if constexpr (detail::PlainNumber<T> || detail::PlainVector<T>) {
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
  } else if constexpr (detail::PlainList<T>) {
    using Item = typename T::value_type;
    if constexpr (detail::PlainNumber<Item> || detail::PlainVector<Item>)
      return write_list(out, value);
    write_value(out, static_cast<uint64_t>(value.size()));
    for (const Item& each : value) write_value(out, each);
  } else if constexpr (detail::PlainOptional<T>) {
    write_value(out, static_cast<uint8_t>(value.has_value()));
    if (value) write_value(out, *value);
  } else {
    visit_members(value, [&](const auto&... members) { (write_value(out, members), ...); });
  }
}

/// Reads such a value. Throws Error(bad_input) if the stream ends before.
template <class T>
void read_value(std::istream& in, T& value) {
  if constexpr (detail::PlainNumber<T> || detail::PlainVector<T>) {
    in.read(reinterpret_cast<char*>(&value), sizeof value);
    if (!in) throw Error(ErrorCode::bad_input, "a stored value ends too early");
  } else if constexpr (detail::PlainList<T>) {
    using Item = typename T::value_type;
    if constexpr (detail::PlainNumber<Item> || detail::PlainVector<Item>) {
      value = read_list<T>(in);
    } else {
      uint64_t count = 0;
      read_value(in, count);
      value.clear();
      for (; count > 0; --count) read_value(in, value.emplace_back());
    }
  } else if constexpr (detail::PlainOptional<T>) {
    uint8_t present = 0;
    read_value(in, present);
    value.reset();
    if (present != 0) read_value(in, value.emplace());
  } else {
    // visit_members has only a constant form, but `value` itself is not constant.
    visit_members(value, [&](const auto&... members) {
      (read_value(in, const_cast<std::remove_cvref_t<decltype(members)>&>(members)), ...);
    });
  }
}

}  // namespace vug

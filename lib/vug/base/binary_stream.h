// SPDX-License-Identifier: Apache-2.0
// Lists of numbers in binary streams, for files that only this machine reads again.
#pragma once

#include <vug/base/error.h>

#include <algorithm>
#include <cstdint>
#include <istream>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace vug {

/// Writes the number of elements and their bytes; T is a number or a struct of numbers without
/// padding, and List is a vector or a string.
template <class List>
void write_list(std::ostream& out, const List& list) {
  using T = typename List::value_type;
  static_assert(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>);
  const auto count = static_cast<uint64_t>(list.size());
  out.write(reinterpret_cast<const char*>(&count), sizeof count);
  out.write(reinterpret_cast<const char*>(list.data()),
            static_cast<std::streamsize>(count * sizeof(T)));
}

/// Reads such a list. Throws Error(bad_input) if the stream ends before.
template <class List>
List read_list(std::istream& in) {
  using T = typename List::value_type;
  constexpr uint64_t kStep = 1 << 20;  // A damaged number of elements must not allocate memory.
  uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof count);
  List list;
  while (in && list.size() < count) {
    const size_t have = list.size();
    list.resize(have + static_cast<size_t>(std::min<uint64_t>(kStep, count - have)));
    in.read(reinterpret_cast<char*>(list.data() + have),
            static_cast<std::streamsize>((list.size() - have) * sizeof(T)));
  }
  if (!in) throw Error(ErrorCode::bad_input, "a stored list ends too early");
  return list;
}

}  // namespace vug

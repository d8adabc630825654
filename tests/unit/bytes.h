// SPDX-License-Identifier: Apache-2.0
// Binary files made by hand, for tests of readers.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>

namespace vug {

/// Appends a number as the machine (little endian) or, if `big`, as network order has it.
template <class T>
void put(std::string& bytes, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace vug

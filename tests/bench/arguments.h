// SPDX-License-Identifier: Apache-2.0
// Arguments of benchmarks.
#pragma once

#include <charconv>
#include <cstring>
#include <system_error>

namespace vug::bench {

/// Reads a number from `low` to `high`. False, with any value in `out`, for other texts.
template <class T>
bool read_number(const char* text, T low, T high, T& out) {
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, out);
  return error == std::errc() && stop == end && out >= low && out <= high;
}

}  // namespace vug::bench
